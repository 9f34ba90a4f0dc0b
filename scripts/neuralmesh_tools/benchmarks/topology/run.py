# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of the topology table: a reconstruction in an isolated process, and its figures."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from neuralmesh_tools import metrics
from neuralmesh_tools.benchmarks.topology.data import Cloud
from neuralmesh_tools.geometry import Faces, Points, diagonal
from neuralmesh_tools.layers import details, document_of, load_plugin
from neuralmesh_tools.methods import METHODS, Task, reconstruct

# Enough for a share of the points to be known to 0.1 % or so.
COVERAGE_SAMPLES = 20_000


@dataclass(frozen=True)
class Job:
    """A cloud and what is asked for. window: see rows.Expected. mesh: where it is kept, if it is.

    distances: whether the RMS distances to the cloud's surface, which take a second, are wanted.
    """

    plugin: Path
    cloud: Cloud
    task: Task
    window: float | None = None
    mesh: Path | None = None
    distances: bool = True


def measure_run(job: Job) -> dict[str, Any]:
    """Reconstruct and return figures as plain values; raises ValueError if there is no mesh."""
    load_plugin(job.plugin)
    cloud = job.cloud
    try:
        result = reconstruct(METHODS["neural-mesh"], document_of(cloud.points), job.task)
    except pymeshlab.PyMeshLabException as problem:
        raise ValueError(details(problem)) from None
    points, faces = result.points, result.faces
    if job.mesh:
        document_of(points, faces).save_current_mesh(str(job.mesh))
    figures = {
        **topology(points, faces),
        "covered": covered(cloud.clean, points, faces),
        "coverage": result.returned.get("coverage"),
        "unsupported_area": result.returned.get("unsupported_area"),
        "volume": volume(points, faces),
        "diagonal": diagonal(points),
        "in_window": 0 if job.window is None else faces_in_window(points, faces, job.window),
        "cpu_seconds": result.cpu_seconds,
    }
    if cloud.surface and job.distances:
        distances = metrics.distances(points, faces, *cloud.surface)
        # The greatest distances look at vertices too and belong to the quality table.
        figures |= {name: distances[name] for name in ("rms_to_mesh", "rms_to_surface")}
    return figures


def topology(points: Points, faces: Faces) -> dict[str, Any]:
    """Counts of a mesh, genus and boundary loops of open meshes included.

    genus is the sum over components, and means nothing where two_manifold is false. oriented: the
    two faces of an edge run along it in opposite directions.
    """
    counts = metrics.topology(points, faces)
    edges, faces_at_edge = metrics.edges(faces)
    vertices = len(np.unique(faces))
    loops = boundary_loops(edges[faces_at_edge == 1])
    characteristic = vertices - len(edges) + len(faces)
    sides = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return {
        "vertices": vertices,
        "components": counts["components"],
        "genus": counts["components"] - (characteristic + loops) // 2,
        "loops": loops,
        "two_manifold": counts["non_manifold_edges"] + counts["non_manifold_vertices"] == 0,
        "oriented": len(np.unique(sides, axis=0)) == len(sides),
        "self_intersecting": counts["self_intersecting"],
    }


def boundary_loops(boundary_edges: Faces) -> int:
    """The number of closed chains that edges (k, 2), two at each of their vertices, make."""
    if len(boundary_edges) == 0:
        return 0
    _, ends = np.unique(boundary_edges, return_inverse=True)
    first, second = ends.reshape(boundary_edges.shape).T
    size = ends.max() + 1
    graph = coo_array((np.ones(len(first)), (first, second)), shape=(size, size))
    return int(connected_components(graph, directed=False)[0])


def covered(clean: Points, points: Points, faces: Faces) -> float:
    """The share of clean points (n, 3) that are at most half a mean edge from the mesh.

    The filter's own figure, coverage, allows a whole edge, which a border that falls short of the
    data by an edge would pass.
    """
    step = -(-len(clean) // COVERAGE_SAMPLES)
    edges, _ = metrics.edges(faces)
    edge = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1).mean()
    # About the data's middle: the answer is in single precision, and data may lie far away.
    middle = points.mean(axis=0)
    found = metrics.point_distances(clean[::step] - middle, points - middle, faces)
    return float(np.mean(found <= edge / 2))


def volume(points: Points, faces: Faces) -> float:
    """The volume that a closed mesh encloses."""
    a, b, c = (points[faces[:, k]] - points.mean(axis=0) for k in range(3))
    return float(abs(np.sum(np.cross(a, b) * c)) / 6)


def faces_in_window(points: Points, faces: Faces, half_width: float) -> int:
    """The number of faces whose centre is in a square about the z axis, seen along it."""
    centres = points[faces].mean(axis=1)
    return int(np.sum(np.abs(centres[:, :2]).max(axis=1) < half_width))
