"""Time of the filter against screened Poisson and decimation, in one process, in turns."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pymeshlab

OURS = "generate_surface_reconstruction_neural_mesh"
SAMPLES = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"


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


def compare_speed(vertices: int, runs: int) -> Speed:
    """Time both methods on the bunny's 28,088 points, `runs` times in turns after a warm-up.

    vertices: of both results; Poisson's is cut to 2 * vertices - 4 faces. Poisson runs at depth 8
    on two threads, with the normals that the file's faces give; ours on one.
    """
    ours: list[float] = []
    poisson: list[float] = []
    for run in range(runs + 1):
        seconds = (_seconds(_run_ours, vertices), _seconds(_run_poisson, vertices))
        if run > 0:
            ours.append(seconds[0])
            poisson.append(seconds[1])
    return Speed(ours, poisson)


def _seconds(method: Callable[[pymeshlab.MeshSet, int], None], vertices: int) -> float:
    mesh_set = pymeshlab.MeshSet(verbose=False)
    mesh_set.load_new_mesh(str(SAMPLES / "bunny.obj"))
    start = time.perf_counter()
    method(mesh_set, vertices)
    seconds = time.perf_counter() - start
    found = mesh_set.current_mesh().vertex_number()
    if abs(found - vertices) > 1:
        raise RuntimeError(f"{method.__name__} made {found} vertices, not {vertices}.")
    return seconds


def _run_ours(mesh_set: pymeshlab.MeshSet, vertices: int) -> None:
    mesh_set.apply_filter(OURS, targetvertnum=vertices)


def _run_poisson(mesh_set: pymeshlab.MeshSet, vertices: int) -> None:
    mesh_set.generate_surface_reconstruction_screened_poisson(depth=8, threads=2)
    mesh_set.meshing_decimation_quadric_edge_collapse(targetfacenum=2 * vertices - 4)
