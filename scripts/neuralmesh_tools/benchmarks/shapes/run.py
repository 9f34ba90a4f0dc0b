# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of one shape: their time, and what the mesh is like."""

from __future__ import annotations

import statistics
import time
from dataclasses import dataclass

from neuralmesh_tools.benchmarks.shapes.data import BENIGN, SHAPES

SEED = 1


@dataclass(frozen=True)
class Job:
    """A shape by name, or the benign one where it has none."""

    shape: str
    points: int
    vertices: int
    runs: int


@dataclass(frozen=True)
class Measured:
    """Seconds of processor time, in the median, and figures of the mesh."""

    seconds: float
    genus: int
    components: int
    self_intersections: int
    coverage: float


def measure(job: Job) -> Measured:
    """Reconstruct the shape so many times, on one thread. Raises what the package raises."""
    import neuralmesh  # other benchmarks need no package

    points = SHAPES.get(job.shape, BENIGN)(job.points, SEED)
    seconds = []
    for _ in range(job.runs):
        before = time.process_time()
        made = neuralmesh.reconstruct(points, vertices=job.vertices, threads=1, random_seed=SEED)
        seconds.append(time.process_time() - before)
    names = ("genus", "components", "self_intersections", "coverage")
    return Measured(statistics.median(seconds), *(made.info[name] for name in names))
