"""Ours and its peers through PyMeshLab, each brought to the same number of vertices.

The seconds of a method are all of what a user would wait for after the points are a layer:
normals where it needs them, the reconstruction, and the decimation.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pymeshlab
from datasets import Faces, Points

OUR_FILTER = "generate_surface_reconstruction_neural_mesh"
NORMAL_NEIGHBOURS = 16
POISSON_DEPTH = 8
# The filter's default, 0.8, leaves more than half of 5 % uniform outliers in on the bunny; 0.3
# leaves a third and costs 1 % of the good points.
OUTLIER_PROBABILITY = 0.3
HOLE_EDGES = 30
DECIMATION_ATTEMPTS = 6

METHODS: dict[str, str] = {
    "ours": "neural mesh, defaults",
    "ours-no-fit": "neural mesh without the closing surface fit",
    "poisson-estimated": "screened Poisson, depth 8, normals estimated from 16 neighbours",
    "poisson-true": "screened Poisson, depth 8, the true normals",
    "poisson-cleaned": "as estimated, after MeshLab's outlier removal, largest component kept",
    "ball-pivoting": "ball pivoting, radius guessed; repaired, holes of up to 30 edges closed",
}
PEERS = [name for name in METHODS if not name.startswith("ours")]


@dataclass
class Result:
    """A reconstruction: vertices (n, 3), faces (m, 3), seconds, and what the filter returned.

    seconds are of the wall clock; cpu_seconds, of all threads, suffer less on a busy machine.
    """

    points: Points
    faces: Faces
    seconds: float
    cpu_seconds: float
    returned: dict[str, Any] = field(default_factory=dict)


def reconstruct(
    method: str,
    points: Points,
    normals: Points,
    vertices: int,
    *,
    threads: int = 1,
    plugin: str = "",
    options: dict[str, Any] | None = None,
) -> Result:
    """Run one method on points (n, 3) with true normals (n, 3), for `vertices` vertices.

    threads is what each method may use; ball pivoting, normals and decimation use one in any case.
    The true normals reach poisson-true only. Raises what PyMeshLab raises.
    """
    mesh_set = pymeshlab.MeshSet(verbose=False)
    if method.startswith("ours"):
        pymeshlab.load_plugin(plugin)
        mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=points))
        if "threads" in mesh_set.filter_parameter_values(OUR_FILTER):
            options = {"threads": threads, **(options or {})}
        return _ours(mesh_set, method, vertices, options or {})
    given = {"v_normals_matrix": normals} if method == "poisson-true" else {}
    mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=points, **given))
    start, cpu_start = time.perf_counter(), time.process_time()
    if method == "poisson-cleaned":
        mesh_set.compute_selection_point_cloud_outliers(propthreshold=OUTLIER_PROBABILITY)
        mesh_set.meshing_remove_selected_vertices()
    if method in ("poisson-estimated", "poisson-cleaned"):
        estimate_normals(mesh_set)
    if method == "ball-pivoting":
        pivot_balls(mesh_set)
    else:
        mesh_set.generate_surface_reconstruction_screened_poisson(
            depth=POISSON_DEPTH, threads=threads
        )
    if method == "poisson-cleaned":
        keep_largest_component(mesh_set)
    reconstruction = mesh_set.current_mesh()
    dense = (reconstruction.vertex_matrix().copy(), reconstruction.face_matrix().copy())
    mesh_set.meshing_decimation_quadric_edge_collapse(targetfacenum=2 * vertices - 4)
    mesh_set.meshing_remove_unreferenced_vertices()
    seconds, cpu_seconds = time.perf_counter() - start, time.process_time() - cpu_start
    return Result(*bring_to_count(mesh_set, dense, vertices), seconds, cpu_seconds)


def pivot_balls(mesh_set: pymeshlab.MeshSet) -> None:
    """Reconstruct the current layer by ball pivoting and repair the result for decimation.

    Decimation tears the many small holes open: without the repair, the error on the clean bone is
    40 times as large.
    """
    mesh_set.generate_surface_reconstruction_ball_pivoting()
    mesh_set.meshing_repair_non_manifold_edges()
    mesh_set.meshing_repair_non_manifold_vertices(vertdispratio=0)
    mesh_set.meshing_close_holes(maxholesize=HOLE_EDGES)


def _ours(
    mesh_set: pymeshlab.MeshSet, method: str, vertices: int, options: dict[str, Any]
) -> Result:
    if method == "ours-no-fit":
        options = {**options, "surfacefit": False}
    start, cpu_start = time.perf_counter(), time.process_time()
    returned = mesh_set.apply_filter(OUR_FILTER, targetvertnum=vertices, **options)
    seconds, cpu_seconds = time.perf_counter() - start, time.process_time() - cpu_start
    kept = {key: _plain(value) for key, value in (returned or {}).items()}
    mesh = mesh_set.current_mesh()
    points, faces = mesh.vertex_matrix().copy(), mesh.face_matrix().copy()
    return Result(points, faces, seconds, cpu_seconds, kept)


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray) else value


def estimate_normals(mesh_set: pymeshlab.MeshSet) -> None:
    """Estimate the current layer's normals, as well as a user would who knows the filter.

    The filter makes neighbouring normals agree but leaves all of them outward or all inward by
    chance: whoever sees an inside-out surface flips them, so this does too.
    """
    mesh_set.compute_normal_for_point_clouds(k=NORMAL_NEIGHBOURS)
    mesh = mesh_set.current_mesh()
    points, normals = mesh.vertex_matrix(), mesh.vertex_normal_matrix()
    if np.sum((points - points.mean(axis=0)) * normals) >= 0:
        return
    mesh_set.clear()
    mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=points.copy(), v_normals_matrix=-normals))


def keep_largest_component(mesh_set: pymeshlab.MeshSet) -> None:
    """Leave only the component with the most faces of the current layer, as the only layer."""
    mesh_set.generate_splitting_by_connected_components(delete_source_mesh=True)
    largest = max(mesh_set, key=lambda mesh: mesh.face_number())
    points, faces = largest.vertex_matrix().copy(), largest.face_matrix().copy()
    mesh_set.clear()
    mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=points, face_matrix=faces))


def bring_to_count(
    mesh_set: pymeshlab.MeshSet, dense: tuple[Points, Faces], vertices: int
) -> tuple[Points, Faces]:
    """Correct the face target until the vertex count is as near to the target as it gets.

    2 n - 4 faces have n vertices only on a sphere; handles, holes and components shift it, and an
    open mesh may end a little off. Not part of the seconds.
    """
    if len(np.unique(dense[1])) <= vertices:
        return dense
    target = 2 * vertices - 4
    mesh = mesh_set.current_mesh()
    best = (mesh.vertex_matrix().copy(), mesh.face_matrix().copy())
    for _ in range(DECIMATION_ATTEMPTS):
        excess = mesh.vertex_number() - vertices
        if excess == 0:
            break
        # A closed mesh loses two faces a vertex; one that is mostly holes is far from that.
        near = abs(excess) < vertices / 10
        target = target - 2 * excess if near else target * vertices // mesh.vertex_number()
        mesh_set.clear()
        mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=dense[0], face_matrix=dense[1]))
        mesh_set.meshing_decimation_quadric_edge_collapse(targetfacenum=target)
        mesh_set.meshing_remove_unreferenced_vertices()
        mesh = mesh_set.current_mesh()
        if abs(mesh.vertex_number() - vertices) < abs(len(best[0]) - vertices):
            best = (mesh.vertex_matrix().copy(), mesh.face_matrix().copy())
    return best
