# SPDX-License-Identifier: GPL-3.0-or-later
"""Throughput of scripts/batch.py with one worker and with two, over the same clouds, in turns."""

from __future__ import annotations

import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.generated_clouds import write_clouds
from neuralmesh_tools.project import SCRIPTS

VERTICES = 1000


@dataclass(frozen=True)
class Throughput:
    """Seconds of each run, start-up included, with one worker and with two; clouds in a run."""

    clouds: int
    one: list[float]
    two: list[float]

    def text(self) -> str:
        """Return the medians, and the median of the ratios, pair by pair, as a line to read."""
        ratios = [a / b for a, b in zip(self.one, self.two, strict=True)]
        one, two = statistics.median(self.one), statistics.median(self.two)
        return (
            f"{self.clouds} clouds, {VERTICES} vertices each: "
            f"one worker {one:.1f} s, two workers {two:.1f} s; "
            f"throughput × {statistics.median(ratios):.2f} (median of {len(ratios)}, "
            f"{min(ratios):.2f} to {max(ratios):.2f})"
        )


def compare_workers(clouds: int, runs: int) -> Throughput:
    """Time whole batches, `runs` of each in turns; every worker has one thread.

    Raises subprocess.CalledProcessError if a batch fails.
    """
    seconds: dict[int, list[float]] = {1: [], 2: []}
    with tempfile.TemporaryDirectory() as folder:
        write_clouds(Path(folder) / "clouds", clouds)
        for run in range(runs):
            for workers, taken in seconds.items():
                out = Path(folder) / f"out{run}-{workers}"
                command = [sys.executable, str(SCRIPTS / "batch.py"), f"{folder}/clouds"]
                command += ["--out", str(out)]
                command += ["--vertices", str(VERTICES), "--workers", str(workers)]
                start = time.perf_counter()
                subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
                taken.append(time.perf_counter() - start)
    return Throughput(clouds, seconds[1], seconds[2])
