# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of the filter against screened Poisson and decimation, in one process, in turns."""

from __future__ import annotations

import statistics
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.layers import load_plugin, read_document
from neuralmesh_tools.methods import TABLE_METHODS, Task, cut_down, reconstruct
from neuralmesh_tools.project import sample_meshes

POISSON_THREADS = 2


@dataclass(frozen=True)
class Speed:
    """Seconds of each run of both methods, in the order in which they ran."""

    ours: list[float]
    poisson: list[float]

    def text(self) -> str:
        """Return medians and the median of the ratios, run by run, as a line to read."""
        ratios = [a / b for a, b in zip(self.ours, self.poisson, strict=True)]
        return (
            f"neural mesh {statistics.median(self.ours):.2f} s, "
            f"Poisson and decimation {statistics.median(self.poisson):.2f} s; ratio "
            f"{statistics.median(ratios):.2f} (median of {len(ratios)}, "
            f"{min(ratios):.2f} to {max(ratios):.2f})"
        )


def compare_speed(plugin: Path, vertices: int, runs: int) -> Speed:
    """Time both methods on the bunny's 28,088 points, `runs` times in turns after a warm-up.

    vertices: of both results; Poisson's is cut to 2 * vertices - 4 faces. Poisson runs at depth 8
    on two threads, with the normals that the file's faces give; ours on one.
    """
    load_plugin(plugin)
    seconds: dict[str, list[float]] = {"ours": [], "poisson-true": []}
    for run in range(runs + 1):
        for name, taken in seconds.items():
            found = _seconds(name, vertices)
            if run > 0:
                taken.append(found)
    return Speed(seconds["ours"], seconds["poisson-true"])


def _seconds(name: str, vertices: int) -> float:
    method = TABLE_METHODS[name]
    threads = 1 if method.exact else POISSON_THREADS
    bunny = read_document(sample_meshes() / "bunny.obj")
    task = Task(vertices, threads, parameters={"threads": threads} if method.exact else {})
    result = cut_down(reconstruct(method, bunny, task), vertices)
    if len(result.points) != vertices:
        raise RuntimeError(f"{name} made {len(result.points)} vertices, not {vertices}.")
    return result.seconds
