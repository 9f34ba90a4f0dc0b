# SPDX-License-Identifier: GPL-3.0-or-later
"""What every mesh keeps, by its arrays alone. Each function says what is wrong, or nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from neuralmesh_tools.geometry import Faces, Points, diagonal
from neuralmesh_tools.metrics import valences
from neuralmesh_tools.properties.inputs import Case
from neuralmesh_tools.properties.runs import Run

# docs/algorithm.md: a vertex is no further outside the box of the points, in its diagonals.
MOST_OUTSIDE = 0.05
# Of the diagonal: rounding, also of coordinates that lie far from the origin.
ROUNDING = 1e-6


def broken_promise(case: Case, run: Run) -> str:
    """Say which promise the mesh of a run breaks first, or nothing."""
    assert run.vertices is not None
    assert run.faces is not None
    target = case.parameters["targetvertnum"]
    meshes = [(run.vertices, run.faces), *run.snapshots]
    for vertices, faces in meshes:
        if wrong := not_manifold(vertices, faces) or far_outside(vertices, case.recipe.points()):
            return wrong
    if snapshots := case.parameters.get("snapshots"):
        counts = [len(vertices) for vertices, _ in run.snapshots]
        if counts != [int(snapshots)]:
            return f"there are snapshots of {counts} vertices, not {snapshots}"
    if len(run.vertices) != target or not run.info["reached_target"]:
        return (
            f"there are {len(run.vertices)} vertices, not {target}, and nothing cut the run short"
        )
    return inside_out(run.vertices, run.faces) or false_figure(run.vertices, run.faces, run.info)


def not_manifold(vertices: Points, faces: Faces) -> str:
    """Say why a mesh is no oriented two-manifold of finite vertices that are all used."""
    if not np.isfinite(vertices).all():
        return "a vertex is not finite"
    if len(faces) == 0 or not np.array_equal(np.unique(faces), np.arange(len(vertices))):
        return "a vertex is of no face, or a face of no vertices"
    sides = _sides(faces)
    if (sides[:, 0] == sides[:, 1]).any():
        return "a face names a vertex twice"
    if len(np.unique(sides, axis=0)) != len(sides):
        return "two faces have an edge in the same direction"
    return "" if all(_is_one_fan(fan) for fan in _fans(faces)) else "fans meet at a vertex"


def far_outside(vertices: Points, points: Points) -> str:
    """Say whether a vertex lies beyond the margin of the points' box, with their strays in it."""
    cloud = points.astype(float)
    size = diagonal(cloud)
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    rounding = ROUNDING * size + 1e-12 * float(np.abs(cloud).max())
    beyond = float(np.max(np.maximum(low - vertices, vertices - high)))
    if beyond > MOST_OUTSIDE * size + rounding:
        return f"a vertex is {beyond / size:.3f} diagonals outside the box of the points"
    return ""


def inside_out(vertices: Points, faces: Faces) -> str:
    """Say whether a closed component has its outside inwards, unless another may enclose it."""
    labels = _labels(vertices, faces)
    size = diagonal(vertices)
    boxes = [(part.min(axis=0), part.max(axis=0)) for part in _by_label(vertices, labels)]
    for label, (low, high) in enumerate(boxes):
        own = faces[labels[faces[:, 0]] == label]
        if len(_boundary(own)):
            continue
        a, b, c = (vertices[own[:, k]] - vertices[own[0, 0]] for k in range(3))
        volume = float(np.sum(a * np.cross(b, c))) / 6
        is_enclosed = any(
            (other_low <= low).all() and (other_high >= high).all()
            for other, (other_low, other_high) in enumerate(boxes)
            if other != label
        )
        if volume < -1e-9 * size**3 and not is_enclosed:
            return f"component {label} is inside out"
    return ""


def false_figure(vertices: Points, faces: Faces, info: dict[str, Any]) -> str:
    """Say which of the figures that are told of a mesh is not true."""
    boundary = _boundary(faces)
    components = int(_labels(vertices, faces).max()) + 1
    # A vertex of an oriented two-manifold lies on one boundary at most.
    loops = len(np.unique(_joined(len(vertices), boundary)[boundary[:, 0]]))
    edges = (3 * len(faces) + len(boundary)) // 2
    euler = len(vertices) - edges + len(faces)
    found = {
        "vertices": len(vertices),
        "faces": len(faces),
        "components": components,
        "boundary_loops": loops,
        "genus": components - (euler + loops) // 2,
    }
    for name, value in found.items():
        if info[name] != value:
            return f"{name} is {value}, but {info[name]} is told"
    histogram = np.bincount(valences(faces))
    told = np.trim_zeros(np.asarray(info["valence_histogram"], dtype=int), "b")
    if not np.array_equal(told, histogram):
        return "the valences are others"
    if not 0 <= info["rms_error"] <= info["max_error"] < np.inf:
        return f"the errors are {info['rms_error']} and {info['max_error']}"
    if not (0 <= info["coverage"] <= 1 and 0 <= info["unsupported_area"] <= 1):
        return "a share is not between 0 and 1"
    return ""


def _sides(faces: Faces) -> NDArray[np.int32]:
    return np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])


def _boundary(faces: Faces) -> NDArray[np.int64]:
    """The directed edges (k, 2) that no other face has the other way round."""
    sides = _sides(faces).astype(np.int64)
    count = int(faces.max()) + 1
    there, back = sides @ [count, 1], sides @ [1, count]
    return sides[~np.isin(there, back)]


def _joined(count: int, pairs: NDArray[Any]) -> NDArray[np.int32]:
    """A label for each of so many vertices: the same where pairs join them."""
    ones = np.ones(len(pairs))
    graph = coo_matrix((ones, (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return connected_components(graph, directed=False)[1]


def _labels(vertices: Points, faces: Faces) -> NDArray[np.int32]:
    return _joined(len(vertices), _sides(faces))


def _by_label(vertices: Points, labels: NDArray[np.int32]) -> list[Points]:
    return [vertices[labels == label] for label in range(int(labels.max()) + 1)]


def _fans(faces: Faces) -> Iterator[dict[int, int]]:
    """For each vertex, from each neighbour to the next around it."""
    fans: dict[int, dict[int, int]] = {}
    for face in faces.tolist():
        for k in range(3):
            fans.setdefault(face[k], {})[face[(k + 1) % 3]] = face[(k + 2) % 3]
    yield from fans.values()


def _is_one_fan(fan: dict[int, int]) -> bool:
    beginnings = fan.keys() - set(fan.values())
    start = at = next(iter(beginnings or fan))
    met = 0
    while at in fan and (at != start or met == 0) and met <= len(fan):
        at = fan[at]
        met += 1
    return met == len(fan)
