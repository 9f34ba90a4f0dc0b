# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of the table of strays: a mesh of a cloud with strays, its RMS and what the log says."""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab

from neuralmesh_tools import metrics
from neuralmesh_tools.benchmarks.strays.data import BODIES, Body, strays
from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.layers import arrays_of, details, load_plugin
from neuralmesh_tools.project import RECONSTRUCT

# Of each case whose mesh is not the very same.
SEEDS = (1, 2, 3, 4, 5)
LEFT_OUT = re.compile(r"([\d,]+) isolated points?")


@dataclass(frozen=True)
class Mesh:
    """A mesh, and how many points the log says were left out."""

    points: Points
    faces: Faces
    left_out: int


@dataclass(frozen=True)
class Job:
    """A body with several sets of strays, each of (kind, count, reach)."""

    plugin: Path
    body: str
    cases: tuple[tuple[str, int, float], ...]


def measure_body(job: Job) -> list[dict[str, Any]]:
    """Figures of each case beside those of the body without strays; {"failure"} where no mesh."""
    load_plugin(job.plugin)
    body = BODIES[job.body]()
    reference = reconstruct(body, body.points)
    true: tuple[float, ...] = ()
    found = []
    for case in job.cases:
        points = np.vstack([body.points, strays(body, *case)])
        try:
            mesh = reconstruct(body, points)
            same = np.array_equal(mesh.points, reference.points)
            if not same:
                true = true or median_rms(body, body.points)
            worse = 1.0 if same else _ratio(median_rms(body, points), true)
        except pymeshlab.PyMeshLabException as problem:
            found.append({"failure": details(problem)})
            continue
        figures = {"strays": len(points) - len(body.points), "left_out": mesh.left_out}
        found.append({**figures, "without": reference.left_out, "ratio": worse, "same": same})
    return found


def _ratio(found: tuple[float, ...], usual: tuple[float, ...]) -> float:
    """The worse direction's."""
    return max(a / b for a, b in zip(found, usual, strict=True))


def median_rms(body: Body, points: Points) -> tuple[float, ...]:
    """RMS both ways, in the median of SEEDS: chance alone moves that of a scan by a fifth."""
    runs = [rms(reconstruct(body, points, seed), body) for seed in SEEDS]
    return tuple(float(value) for value in np.median(runs, axis=0))


def rms(mesh: Mesh, body: Body) -> tuple[float, float]:
    """RMS distances from the surface to the mesh and back, in per cent of the diagonal."""
    found = metrics.distances(mesh.points, mesh.faces, *body.surface)
    return found["rms_to_mesh"], found["rms_to_surface"]


def reconstruct(body: Body, points: Points, seed: int = SEEDS[0]) -> Mesh:
    """Reconstruct points, and read the log; raises what PyMeshLab raises."""
    document = pymeshlab.MeshSet(verbose=True)
    document.add_mesh(pymeshlab.Mesh(vertex_matrix=points))
    parameters = {"targetvertnum": body.vertices, "randomseed": seed, **body.parameters}
    log = _logged(lambda: document.apply_filter(RECONSTRUCT, **parameters))
    said = LEFT_OUT.search(log)
    return Mesh(*arrays_of(document), int(said[1].replace(",", "")) if said else 0)


def _logged(call: Callable[[], object]) -> str:
    """What the call writes to the standard error, which C++ writes to as well."""
    with tempfile.TemporaryFile() as stream:
        usual = os.dup(2)
        os.dup2(stream.fileno(), 2)
        try:
            call()
        finally:
            os.dup2(usual, 2)
            os.close(usual)
        stream.seek(0)
        return stream.read().decode(errors="replace")
