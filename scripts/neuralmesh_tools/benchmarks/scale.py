# SPDX-License-Identifier: GPL-3.0-or-later
"""Time against vertices, points and threads, by the package neuralmesh."""

from __future__ import annotations

import statistics
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from neuralmesh_tools.geometry import Faces, Points, sample_surface
from neuralmesh_tools.quality.models import load

MODEL = "armadillo"
POINTS_PER_VERTEX = 8
FEWEST_POINTS = 100_000
VERTICES_FOR_POINTS = 5000
SEED = 1


@dataclass(frozen=True)
class Case:
    """What is measured: a mesh of so many vertices from so many points on so many threads."""

    vertices: int
    points: int
    threads: int


@dataclass(frozen=True)
class ScaleRow:
    """Medians of the runs of a case, in seconds: on the clock and of all processors."""

    case: Case
    wall: float
    cpu: float

    def text(self) -> str:
        """Return the row of a table in Markdown."""
        case = self.case
        per_vertex = f"{1e6 * self.wall / case.vertices:.0f} | {1e6 * self.cpu / case.vertices:.0f}"
        return (
            f"| {case.vertices:,} | {case.points:,} | {case.threads} "
            f"| {self.wall:.2f} | {self.cpu:.2f} | {per_vertex} |"
        )

    def as_json(self) -> dict[str, Any]:
        """Return the fields by name."""
        return {**asdict(self.case), "wall_seconds": self.wall, "cpu_seconds": self.cpu}


HEADER = (
    "| vertices | points | threads | wall, s | CPU, s | wall a vertex, µs | CPU a vertex, µs |\n"
    "|---|---|---|---|---|---|---|"
)


def cases(vertices: list[int], points: list[int], threads: list[int]) -> list[Case]:
    """Return each count of vertices with 8 points a vertex, then each count of points.

    No cloud has fewer than 100,000 points; clouds of other sizes become meshes of 5,000 vertices.
    """
    by_vertices = [(count, max(FEWEST_POINTS, POINTS_PER_VERTEX * count)) for count in vertices]
    by_points = [(VERTICES_FOR_POINTS, count) for count in points]
    return [Case(v, p, t) for v, p in by_vertices + by_points for t in threads]


def measure(chosen: list[Case], runs: int) -> Iterator[ScaleRow]:
    """Yield a row for each case: points of the armadillo, `runs` times."""
    surface = load(MODEL)
    clouds: dict[int, Points] = {}
    for case in chosen:
        if case.points not in clouds:
            clouds = {case.points: _cloud(surface, case.points)}  # one at a time: they are large
        taken = [_seconds(clouds[case.points], case) for _ in range(runs)]
        wall, cpu = (statistics.median(column) for column in zip(*taken, strict=True))
        yield ScaleRow(case, wall, cpu)


def _cloud(surface: tuple[Points, Faces], count: int) -> Points:
    points, _ = sample_surface(*surface, count, np.random.default_rng(SEED))
    return np.ascontiguousarray(points)


def _seconds(points: Points, case: Case) -> tuple[float, float]:
    import neuralmesh  # other benchmarks need no package

    wall, cpu = time.perf_counter(), time.process_time()
    result = neuralmesh.reconstruct(
        points, vertices=case.vertices, threads=case.threads, random_seed=SEED
    )
    taken = time.perf_counter() - wall, time.process_time() - cpu
    if len(result.vertices) != case.vertices:
        raise RuntimeError(f"{len(result.vertices)} vertices were made, not {case.vertices}.")
    return taken
