# SPDX-License-Identifier: GPL-3.0-or-later
"""The registry of reconstruction filters that are compared, and how each is run.

A method is a name, what tables and sentences call it, and steps, each of which works on the current
layer of a document. The seconds of a method are all of what a user waits for after the points are a
layer: normals where it estimates them, the reconstruction, its repairs, and the decimation.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
import pymeshlab

from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.layers import arrays_of, document_of, figures_of
from neuralmesh_tools.project import RECONSTRUCT

NORMAL_NEIGHBOURS = 16
POISSON_DEPTH = 8
# Of Poisson at its best: what its users turn first. Noise asks for more neighbours and less depth.
BEST_NEIGHBOURS = (16, 64)
BEST_DEPTHS = (7, 8, 9)
# The filter's default, 0.8, leaves more than half of 5 % uniform outliers in on the bunny; 0.3
# leaves a third and costs 1 % of the good points.
OUTLIER_PROBABILITY = 0.3
HOLE_EDGES = 30
# Twice the spacing: then nearly every voxel on the surface has a point, which splatting asks for.
VOXEL_SPACINGS = 2.0
# Wide enough to bridge the gaps between neighbours, too narrow to fill the inside.
ALPHA_SPACINGS = 3.0
DECIMATION_ATTEMPTS = 6


@dataclass(frozen=True)
class Task:
    """What a method is asked for: so many vertices, with so many threads at most.

    spacing: the median distance of a point to its nearest neighbour, in the input's units; 0 if it
    is not known. outliers: whether the points are known to hold some. parameters: of the filter,
    for ours only.
    """

    vertices: int
    threads: int = 1
    spacing: float = 0.0
    outliers: bool = False
    parameters: dict[str, Any] = field(default_factory=dict)


Step = Callable[[pymeshlab.MeshSet, Task], dict[str, Any] | None]


@dataclass(frozen=True)
class Method:
    """A filter with what belongs to it. exact: it makes the count of vertices that it is asked for.

    label: of it in a table; name: in a sentence; about: what it does, in a line. needs_normals: it
    takes those of the layer. parameters: of the filter, for ours, that differ from the defaults.
    settings: where it is the best of several: those, each with its label; it has no steps then.
    """

    label: str
    name: str
    about: str
    steps: tuple[Step, ...] = ()
    needs_normals: bool = False
    exact: bool = False
    parameters: dict[str, Any] = field(default_factory=dict)
    settings: tuple[Method, ...] = ()


@dataclass(frozen=True)
class Reconstruction:
    """Vertices (n, 3), faces (m, 3), the seconds it took, and the figures that the filter returned.

    seconds are of the wall clock; cpu_seconds, of all threads, suffer less on a busy machine.
    """

    points: Points
    faces: Faces
    seconds: float
    cpu_seconds: float = 0.0
    returned: dict[str, Any] = field(default_factory=dict)


def reconstruct(method: Method, document: pymeshlab.MeshSet, task: Task) -> Reconstruction:
    """Run a method on the current layer of a document and return what is then its current layer.

    The document is used up. Only an exact method has the count of vertices asked for: see cut_down.
    Raises ValueError if there are no faces, and what PyMeshLab raises.
    """
    returned: dict[str, Any] | None = None
    task = replace(task, parameters={**method.parameters, **task.parameters})
    start, cpu_start = time.perf_counter(), time.process_time()
    for step in method.steps:
        returned = step(document, task) or returned
    seconds, cpu_seconds = time.perf_counter() - start, time.process_time() - cpu_start
    points, faces = arrays_of(document)
    if len(faces) == 0:
        raise ValueError("It made no faces.")
    return Reconstruction(points, faces, seconds, cpu_seconds, figures_of(returned))


def cut_down(
    dense: Reconstruction, vertices: int, attempts: int = DECIMATION_ATTEMPTS
) -> Reconstruction:
    """Decimate a mesh by quadrics to a count; one that has fewer vertices stays as it is.

    attempts: after the first, to meet the count more exactly. The seconds are those of the mesh and
    of the first decimation, which is all a user would do.
    """
    if len(np.unique(dense.faces)) <= vertices:
        return dense
    start, cpu_start = time.perf_counter(), time.process_time()
    document = _decimated(dense, 2 * vertices - 4)
    seconds, cpu_seconds = time.perf_counter() - start, time.process_time() - cpu_start
    points, faces = _bring_to_count(dense, arrays_of(document), vertices, attempts)
    return Reconstruction(
        points, faces, dense.seconds + seconds, dense.cpu_seconds + cpu_seconds, dense.returned
    )


def _decimated(dense: Reconstruction, faces: int) -> pymeshlab.MeshSet:
    document = document_of(dense.points, dense.faces)
    document.meshing_decimation_quadric_edge_collapse(targetfacenum=faces)
    document.meshing_remove_unreferenced_vertices()
    return document


def _bring_to_count(
    dense: Reconstruction, best: tuple[Points, Faces], vertices: int, attempts: int
) -> tuple[Points, Faces]:
    """Correct the face target until the vertex count is as near to the target as it gets.

    best: what the first decimation gave. 2 n - 4 faces have n vertices only on a sphere; handles,
    holes and components shift it, and an open mesh may end a little off.
    """
    target = 2 * vertices - 4
    count = len(best[0])
    for _ in range(attempts):
        excess = count - vertices
        if excess == 0:
            break
        # A closed mesh loses two faces a vertex; one that is mostly holes is far from that.
        near = abs(excess) < vertices / 10
        target = target - 2 * excess if near else target * vertices // count
        document = _decimated(dense, target)
        count = document.current_mesh().vertex_number()
        if abs(count - vertices) < abs(len(best[0]) - vertices):
            best = arrays_of(document)
    return best


# ------------------------------------------------------------------------------------- the steps


def neural_mesh(document: pymeshlab.MeshSet, task: Task) -> dict[str, Any] | None:
    """Our filter; its plugin has to be loaded."""
    parameters = {"targetvertnum": task.vertices, **task.parameters}
    if "threads" in document.filter_parameter_values(RECONSTRUCT):
        parameters.setdefault("threads", task.threads)
    returned: dict[str, Any] | None = document.apply_filter(RECONSTRUCT, **parameters)
    return returned


def poisson(document: pymeshlab.MeshSet, task: Task, depth: int = POISSON_DEPTH) -> None:
    """Screened Poisson with the normals that the layer has."""
    document.generate_surface_reconstruction_screened_poisson(depth=depth, threads=task.threads)


def estimate_normals(
    document: pymeshlab.MeshSet, _: Task | None = None, neighbours: int = NORMAL_NEIGHBOURS
) -> None:
    """Estimate the current layer's normals, as well as a user would who knows the filter.

    The filter makes neighbouring normals agree but leaves all of them outward or all inward by
    chance: whoever sees an inside-out surface flips them, so this does too.
    """
    document.compute_normal_for_point_clouds(k=neighbours)
    mesh = document.current_mesh()
    points, normals = mesh.vertex_matrix(), mesh.vertex_normal_matrix()
    if np.sum((points - points.mean(axis=0)) * normals) >= 0:
        return
    flipped = pymeshlab.Mesh(vertex_matrix=points.copy(), v_normals_matrix=-normals)
    document.clear()
    document.add_mesh(flipped)


def remove_known_outliers(document: pymeshlab.MeshSet, task: Task) -> None:
    """MeshLab's own outlier removal, where the points are known to hold some."""
    if not task.outliers:
        return
    document.compute_selection_point_cloud_outliers(propthreshold=OUTLIER_PROBABILITY)
    document.meshing_remove_selected_vertices()


def keep_largest_component(document: pymeshlab.MeshSet, _: Task) -> None:
    """Leave only the component with the most faces of the current layer, as the only layer."""
    document.generate_splitting_by_connected_components(delete_source_mesh=True)
    largest = max(document, key=lambda mesh: mesh.face_number())
    points, faces = arrays_of(document, largest.id())
    document.clear()
    document.add_mesh(pymeshlab.Mesh(vertex_matrix=points, face_matrix=faces))


def pivot_balls(document: pymeshlab.MeshSet, _: Task) -> None:
    """Reconstruct the current layer by ball pivoting and repair the result for decimation.

    Decimation tears the many small holes open: without the repair, the error on the clean bone is
    40 times as large.
    """
    document.generate_surface_reconstruction_ball_pivoting()
    document.meshing_repair_non_manifold_edges()
    document.meshing_repair_non_manifold_vertices(vertdispratio=0)
    document.meshing_close_holes(maxholesize=HOLE_EDGES)


def vcg_volume(document: pymeshlab.MeshSet, task: Task) -> None:
    """Splat the points into voxels and take the surface out of them."""
    voxel = pymeshlab.PureValue(VOXEL_SPACINGS * task.spacing)
    document.generate_surface_reconstruction_vcg(voxsize=voxel, mergecolor=True)


def alpha_shape(document: pymeshlab.MeshSet, task: Task) -> None:
    """The alpha shape of the points."""
    alpha = pymeshlab.PureValue(ALPHA_SPACINGS * task.spacing)
    document.generate_alpha_shape(alpha=alpha, filtering="Alpha Shape")


# ---------------------------------------------------------------------------------- the registry


METHODS: dict[str, Method] = {
    "neural-mesh": Method(
        "Neural Mesh",
        "Neural Mesh",
        "this project's filter, defaults; no normals needed",
        (neural_mesh,),
        exact=True,
    ),
    "poisson": Method(
        "Screened Poisson",
        "screened Poisson",
        f"depth {POISSON_DEPTH}, largest part kept",
        (poisson, keep_largest_component),
        needs_normals=True,
    ),
    "ball-pivoting": Method(
        "Ball pivoting",
        "ball pivoting",
        f"radius guessed, repaired, holes of up to {HOLE_EDGES} edges closed",
        (pivot_balls,),
    ),
    "vcg": Method(
        "VCG volume",
        "the VCG volume",
        f"points splatted into voxels of {VOXEL_SPACINGS:g} spacings",
        (vcg_volume,),
        needs_normals=True,
    ),
    "alpha-shape": Method(
        "Alpha shape",
        "the alpha shape",
        f"balls of {ALPHA_SPACINGS:g} spacings; no normals needed",
        (alpha_shape,),
    ),
}


def alternatives(values: Sequence[int]) -> str:
    """The values as a sentence has them: 7, 8 or 9."""
    *first, last = values
    return f"{', '.join(map(str, first))} or {last}"


def poisson_with(neighbours: int, depth: int) -> Method:
    """Poisson for one connected surface, with normals estimated from so many neighbours."""
    steps = (
        remove_known_outliers,
        partial(estimate_normals, neighbours=neighbours),
        partial(poisson, depth=depth),
        keep_largest_component,
    )
    setting = f"{neighbours} neighbours, depth {depth}"
    return Method(setting, METHODS["poisson"].name, setting, steps)


# The rows of the quality table: the same filters, told apart by where normals come from.
TABLE_METHODS: dict[str, Method] = {
    "ours": METHODS["neural-mesh"],
    "ours-no-fit": replace(
        METHODS["neural-mesh"],
        about="the same without the closing surface fit",
        parameters={"surfacefit": False},
    ),
    "poisson-true": replace(
        METHODS["poisson"], about=f"depth {POISSON_DEPTH}, the true normals", steps=(poisson,)
    ),
    "poisson-best": Method(
        "Poisson at its best",
        METHODS["poisson"].name,
        f"normals from {alternatives(BEST_NEIGHBOURS)} neighbours, depth "
        f"{alternatives(BEST_DEPTHS)}: what is "
        "best for each input; outliers removed where there are some, largest part kept",
        settings=tuple(
            poisson_with(neighbours, depth)
            for neighbours in BEST_NEIGHBOURS
            for depth in BEST_DEPTHS
        ),
    ),
    "ball-pivoting": METHODS["ball-pivoting"],
}
PEERS = [name for name, method in TABLE_METHODS.items() if not method.exact]
