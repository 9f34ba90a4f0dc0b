# SPDX-License-Identifier: GPL-3.0-or-later
"""The reconstruction filters of PyMeshLab, each cut down to the same numbers of vertices.

Each runs in an isolated process, in a folder of its own: one of them leaves files behind.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pymeshlab
from datasets import Faces, Points
from quality.methods import (
    HOLE_EDGES,
    OUR_FILTER,
    POISSON_DEPTH,
    bring_to_count,
    keep_largest_component,
    pivot_balls,
)

from comparison.clouds import Cloud

# Twice the spacing: then nearly every voxel on the surface has a point, which splatting asks for.
VOXEL_SPACINGS = 2.0
# Wide enough to bridge the gaps between neighbours, too narrow to fill the inside.
ALPHA_SPACINGS = 3.0


@dataclass(frozen=True)
class Method:
    """A filter: how tables call it, how sentences do, and what it does, in a line."""

    label: str
    name: str
    about: str


METHODS: dict[str, Method] = {
    "neural-mesh": Method(
        "Neural Mesh", "Neural Mesh", "this project's filter, defaults; no normals needed"
    ),
    "poisson": Method(
        "Screened Poisson", "screened Poisson", f"depth {POISSON_DEPTH}, largest part kept"
    ),
    "ball-pivoting": Method(
        "Ball pivoting",
        "ball pivoting",
        f"radius guessed, repaired, holes of up to {HOLE_EDGES} edges closed",
    ),
    "vcg": Method(
        "VCG volume",
        "the VCG volume",
        f"points splatted into voxels of {VOXEL_SPACINGS:g} spacings",
    ),
    "alpha-shape": Method(
        "Alpha shape",
        "the alpha shape",
        f"balls of {ALPHA_SPACINGS:g} spacings; no normals needed",
    ),
}


@dataclass(frozen=True)
class Mesh:
    """A result of so many vertices as asked for, as near as the method gets.

    seconds: all that a user waits for: the reconstruction, and cutting down.
    """

    asked: int
    points: Points
    faces: Faces
    seconds: float


def reconstruct(
    method: str, cloud: Cloud, counts: list[int], plugin: str, threads: int
) -> list[Mesh]:
    """Reconstruct a cloud and return a mesh for each count of vertices, the largest first.

    Our filter runs once a count; the others once, and are then decimated, each from the mesh
    before. Normals are those of the
    cloud; the time to estimate them is not counted. Raises ValueError if a result has no faces,
    and what PyMeshLab raises.
    """
    if method == "neural-mesh":
        pymeshlab.load_plugin(plugin)
        return [_neural_mesh(cloud, count, threads) for count in counts]
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(vertex_matrix=cloud.points, v_normals_matrix=cloud.normals))
    start = time.perf_counter()
    _FILTERS[method](document, cloud, threads)
    seconds = time.perf_counter() - start
    mesh = document.current_mesh()
    dense = (mesh.vertex_matrix().copy(), mesh.face_matrix().copy())
    if len(dense[1]) == 0:
        raise ValueError("It made no faces.")
    meshes = []
    for count in sorted(counts, reverse=True):
        meshes.append(_cut_down(dense, count, seconds))
        dense, seconds = (meshes[-1].points, meshes[-1].faces), meshes[-1].seconds
    return meshes


def _neural_mesh(cloud: Cloud, count: int, threads: int) -> Mesh:
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(vertex_matrix=cloud.points))
    start = time.perf_counter()
    options = {"targetvertnum": count}
    if "threads" in document.filter_parameter_values(OUR_FILTER):
        options["threads"] = threads
    document.apply_filter(OUR_FILTER, **options)
    seconds = time.perf_counter() - start
    mesh = document.current_mesh()
    return Mesh(count, mesh.vertex_matrix().copy(), mesh.face_matrix().copy(), seconds)


def _cut_down(dense: tuple[Points, Faces], count: int, seconds: float) -> Mesh:
    """Decimate by quadrics to a count; a mesh that has fewer vertices stays as it is."""
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(vertex_matrix=dense[0], face_matrix=dense[1]))
    start = time.perf_counter()
    if len(np.unique(dense[1])) > count:
        document.meshing_decimation_quadric_edge_collapse(targetfacenum=2 * count - 4)
        document.meshing_remove_unreferenced_vertices()
    seconds += time.perf_counter() - start
    return Mesh(count, *bring_to_count(document, dense, count), seconds)


def _poisson(document: pymeshlab.MeshSet, cloud: Cloud, threads: int) -> None:
    document.generate_surface_reconstruction_screened_poisson(depth=POISSON_DEPTH, threads=threads)
    keep_largest_component(document)


def _ball_pivoting(document: pymeshlab.MeshSet, cloud: Cloud, threads: int) -> None:
    pivot_balls(document)


def _vcg(document: pymeshlab.MeshSet, cloud: Cloud, threads: int) -> None:
    voxel = pymeshlab.PureValue(VOXEL_SPACINGS * cloud.spacing)
    document.generate_surface_reconstruction_vcg(voxsize=voxel, mergecolor=True)


def _alpha_shape(document: pymeshlab.MeshSet, cloud: Cloud, threads: int) -> None:
    alpha = pymeshlab.PureValue(ALPHA_SPACINGS * cloud.spacing)
    document.generate_alpha_shape(alpha=alpha, filtering="Alpha Shape")


_FILTERS: dict[str, Callable[[pymeshlab.MeshSet, Cloud, int], None]] = {
    "poisson": _poisson,
    "ball-pivoting": _ball_pivoting,
    "vcg": _vcg,
    "alpha-shape": _alpha_shape,
}
