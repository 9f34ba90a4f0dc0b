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
    """Seconds of each run, in the order in which they ran: ours on one thread and on two."""

    ours: list[float]
    ours_on_two: list[float]
    poisson: list[float]

    def text(self) -> str:
        """Return medians and the medians of the ratios, run by run, as a line to read."""
        return (
            f"neural mesh {statistics.median(self.ours):.2f} s, "
            f"Poisson and decimation {statistics.median(self.poisson):.2f} s; ratio "
            f"{_ratio(self.ours, self.poisson)}; on two threads "
            f"{_ratio(self.ours_on_two, self.ours)} of one"
        )


def _ratio(seconds: list[float], others: list[float]) -> str:
    ratios = [a / b for a, b in zip(seconds, others, strict=True)]
    return (
        f"{statistics.median(ratios):.2f} (median of {len(ratios)}, "
        f"{min(ratios):.2f} to {max(ratios):.2f})"
    )


def compare_speed(plugin: Path, vertices: int, runs: int) -> Speed:
    """Time all on the bunny's 28,088 points, `runs` times in turns after a warm-up.

    vertices: of the results; Poisson's is cut to 2 * vertices - 4 faces. Poisson runs at depth 8
    on two threads, with the normals that the file's faces give.
    """
    load_plugin(plugin)
    speed = Speed([], [], [])
    for run in range(runs + 1):
        found = [
            _seconds("ours", vertices, 1),
            _seconds("ours", vertices, 2),
            _seconds("poisson-true", vertices, POISSON_THREADS),
        ]
        if run > 0:
            for taken, seconds in zip(
                (speed.ours, speed.ours_on_two, speed.poisson), found, strict=True
            ):
                taken.append(seconds)
    return speed


def _seconds(name: str, vertices: int, threads: int) -> float:
    method = TABLE_METHODS[name]
    bunny = read_document(sample_meshes() / "bunny.obj")
    task = Task(vertices, threads, parameters={"threads": threads} if method.exact else {})
    result = cut_down(reconstruct(method, bunny, task), vertices)
    if len(result.points) != vertices:
        raise RuntimeError(f"{name} made {len(result.points)} vertices, not {vertices}.")
    return result.seconds
