# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of `scripts/test --mutants`."""

from __future__ import annotations

import argparse
import os
import re
import sys
import tempfile
import textwrap
from collections.abc import Sequence
from pathlib import Path

from neuralmesh_tools.changed_build import BuildFailed, BuiltProgram, Stale
from neuralmesh_tools.mutants.catalogue import MUTANTS
from neuralmesh_tools.mutants.mutant import Mutant
from neuralmesh_tools.mutants.run import Verdict, failing_tests, judge_all
from neuralmesh_tools.project import ROOT

DESCRIPTION = """\
Switches off one mechanism of the core at a time and runs the C++ tests that are to notice.

Works beside the build in build/release, which it brings up to date first, and leaves the checkout
as it is. Exit codes: 0 each mutant was caught, 1 some were not, 2 nothing could be judged (usage,
a mutant that no longer fits the source, a build or a test that fails without any change)."""


class Unusable(RuntimeError):
    """What was asked for cannot be done; the message says why."""


def selected(mutants: Sequence[Mutant], names: Sequence[str], part: str | None) -> list[Mutant]:
    """Return the mutants with these names, or all; of them, where part is "K/N", every N-th.

    Raises Unusable for a name or a part that there is not.
    """
    known = {mutant.name: mutant for mutant in mutants}
    if unknown := [name for name in names if name not in known]:
        raise Unusable(f"There is no mutant {unknown[0]}; there are: {', '.join(known)}.")
    chosen = [known[name] for name in names] or list(mutants)
    if part is None:
        return chosen
    match = re.fullmatch(r"(\d+)/(\d+)", part)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise Unusable(f"--part takes K/N with K from 1 to N, not {part}.")
    return chosen[int(match[1]) - 1 :: int(match[2])]


def _arguments(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="scripts/test --mutants",
        description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--list", action="store_true", help="only say what there is")
    parser.add_argument(
        "--only", action="append", default=[], metavar="NAME", help="this one (may be repeated)"
    )
    parser.add_argument("--part", metavar="K/N", help="every N-th, from the K-th on")
    parser.add_argument(
        "--jobs", type=int, default=os.cpu_count(), metavar="N", help="at a time (default: cores)"
    )
    return parser.parse_args(arguments)


def _say(verdict: Verdict) -> None:
    how = "caught" if verdict.is_caught else "SURVIVED"
    print(f"{how:8} {verdict.mutant.name}: {verdict.mutant.switches_off}")
    found = ", ".join(verdict.caught_by) or "no test at all"
    missed = ", ".join(verdict.missed_by)
    text = f"by {found}" if verdict.is_caught else f"not by {missed}, but by {found}"
    for line in textwrap.wrap(f"{text} ({verdict.seconds:.0f} s)", 88, break_long_words=False):
        print(f"         {line}", flush=True)


def _judge(mutants: Sequence[Mutant], jobs: int) -> int:
    for mutant in mutants:
        mutant.applied(ROOT)
    build = BuiltProgram(ROOT, ROOT / "build" / "release")
    own = sorted({test for mutant in mutants for test in mutant.tests})
    if failing := failing_tests(build.executable, own):
        raise Unusable(f"Without any change these fail: {', '.join(failing)}.")
    survivors = 0
    with tempfile.TemporaryDirectory(prefix="neuralmesh-mutants-") as scratch:
        for verdict in judge_all(build, mutants, ROOT, Path(scratch), jobs):
            _say(verdict)
            survivors += not verdict.is_caught
    print(f"{len(mutants) - survivors} of {len(mutants)} mutants were caught.")
    return 1 if survivors else 0


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    options = _arguments(arguments)
    try:
        mutants = selected(MUTANTS, options.only, options.part)
        if not options.list:
            return _judge(mutants, options.jobs)
    except (BuildFailed, Stale, Unusable) as error:
        print(error, file=sys.stderr)
        return 2
    for mutant in mutants:
        print(f"{mutant.name}: {mutant.switches_off}\n    {', '.join(mutant.tests)}")
    return 0
