# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds mutants, runs their tests, and says what became of each."""

from __future__ import annotations

import re
import shutil
import subprocess
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.changed_build import BuiltProgram
from neuralmesh_tools.mutants.mutant import Mutant

# A mutant may make a loop endless. The tests of one take seconds, all of them less than a minute.
TIMEOUT = 300.0
_FAILED = re.compile(r"^\[  FAILED  \] (\w+\.\w+)", re.MULTILINE)
_RUN = re.compile(r"^\[ RUN      \] (\w+\.\w+)", re.MULTILINE)
_END = re.compile(r"^\[=+\] .* ran\.", re.MULTILINE)


@dataclass(frozen=True)
class Verdict:
    """What became of a mutant."""

    mutant: Mutant
    caught_by: tuple[str, ...]
    """The tests that failed: of its own, or where one of these did not, of all."""
    seconds: float

    @property
    def missed_by(self) -> tuple[str, ...]:
        """Its own tests that did not notice."""
        return tuple(test for test in self.mutant.tests if test not in self.caught_by)

    @property
    def is_caught(self) -> bool:
        """Whether each of its own tests failed."""
        return not self.missed_by


def failing_tests(executable: Path, tests: Iterable[str] = ("*",)) -> tuple[str, ...]:
    """Run tests by name and return those that fail, crash or take longer than TIMEOUT."""
    # Of a run that does not come to its end, the test that it was at is the one that failed.
    command = [str(executable), f"--gtest_filter={':'.join(tests)}"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        output = done.stdout
    except subprocess.TimeoutExpired as late:
        output = (late.stdout or b"").decode(errors="replace")
    failed = dict.fromkeys(_FAILED.findall(output))
    if not _END.search(output) and (started := _RUN.findall(output)):
        failed[started[-1]] = None
    return tuple(failed)


def judge(build: BuiltProgram, mutant: Mutant, root: Path, scratch: Path) -> Verdict:
    """Build and test one mutant. scratch is a folder that is made and removed again."""
    start = time.monotonic()
    scratch.mkdir(parents=True)
    try:
        executable = build.with_change(mutant.path, mutant.applied(root), scratch)
        caught_by = failing_tests(executable, mutant.tests)
        if set(mutant.tests) - set(caught_by):
            caught_by = failing_tests(executable)
    finally:
        shutil.rmtree(scratch)
    return Verdict(mutant, caught_by, time.monotonic() - start)


def judge_all(
    build: BuiltProgram, mutants: Iterable[Mutant], root: Path, scratch: Path, jobs: int
) -> Iterator[Verdict]:
    """Judge mutants, several at a time, and yield the verdicts in their order."""
    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(lambda m: judge(build, m, root, scratch / m.name), mutants)
