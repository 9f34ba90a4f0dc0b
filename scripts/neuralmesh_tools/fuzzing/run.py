# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of libFuzzer on a target, and its figures."""

from __future__ import annotations

import os
import re
import resource
import subprocess
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.fuzzing.seeds import write_seeds
from neuralmesh_tools.project import ROOT

BUILD = ROOT / "build" / "fuzz" / "filter_neuralmesh" / "fuzz"
REGRESSIONS = ROOT / "filter_neuralmesh" / "fuzz" / "regressions"
# Bytes of an input, seconds for one by the clock, which others may keep busy, and megabytes.
MOST_BYTES = {
    "ring_operations": 400,
    "point_file_headers": 3000,
    "expressions": 300,
    "reconstructions": 2200,
}
SECONDS_EACH = 100
MEGABYTES = 1500
_COUNTERS = re.compile(r"Loaded \d+ modules +\((\d+) inline 8-bit counters\)")
_COVERED = re.compile(r"\bcov: (\d+)")
_EXECUTIONS = re.compile(r"stat::number_of_executed_units: (\d+)")
_WRITTEN = re.compile(r"Test unit written to (\S+)")


@dataclass(frozen=True)
class Fuzzed:
    """What a run came to. covered and edges are branches of the code that was compiled in."""

    target: str
    executions: int
    covered: int
    edges: int
    cpu_seconds: float
    findings: tuple[Path, ...]
    is_clean: bool
    log: Path

    def line(self) -> str:
        """One line for people."""
        verdict = "clean" if self.is_clean else f"FOUND {', '.join(map(str, self.findings))}"
        return (
            f"{self.target:19} {self.executions:>11,} executions, {self.covered:,} of "
            f"{self.edges:,} edges, {self.cpu_seconds / 60:.1f} CPU minutes: {verdict}"
        )


def fuzz(target: str, seconds: int, out: Path, seed: int) -> Fuzzed:
    """Run a target for so long, on from what earlier runs found to be worth keeping.

    What breaks it is left in the folder findings of out / target, and the log beside it.
    """
    folder = out / target
    kept, findings = folder / "corpus", folder / "findings"
    for each in (kept, findings):
        each.mkdir(parents=True, exist_ok=True)
    write_seeds(target, folder)
    dictionary = folder / "dictionary"
    regressions = REGRESSIONS / target
    command = [
        str(BUILD / f"fuzz_{target}"),
        f"-max_total_time={seconds}",
        f"-max_len={MOST_BYTES[target]}",
        f"-timeout={SECONDS_EACH}",
        f"-rss_limit_mb={MEGABYTES}",
        f"-seed={seed}",
        f"-artifact_prefix={findings}/",
        "-print_final_stats=1",
        *([f"-dict={dictionary}"] if dictionary.is_file() else []),
        *(str(place) for place in (kept, folder / "seeds", regressions) if place.is_dir()),
    ]
    before = _children_cpu()
    log = folder / "log"
    with log.open("wb") as stream:
        done = subprocess.run(command, stdout=stream, stderr=stream, env=_environment())
    return _result(target, done.returncode, _children_cpu() - before, log)


def _environment() -> dict[str, str]:
    """As it is, but that a sanitizer lets an allocation fail that is too large, as systems do."""
    given = os.environ.get("ASAN_OPTIONS", "")
    return os.environ | {"ASAN_OPTIONS": f"allocator_may_return_null=1:{given}"}


def _children_cpu() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _result(target: str, code: int, cpu_seconds: float, log: Path) -> Fuzzed:
    text = log.read_text(encoding="utf-8", errors="replace")
    number = {
        name: int(found[-1]) if (found := pattern.findall(text)) else 0
        for name, pattern in (("e", _EXECUTIONS), ("c", _COVERED), ("n", _COUNTERS))
    }
    findings = tuple(Path(name) for name in _WRITTEN.findall(text))
    return Fuzzed(
        target, number["e"], number["c"], number["n"], cpu_seconds, findings, code == 0, log
    )
