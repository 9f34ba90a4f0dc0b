# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed triangle meshes with sharp features or thin parts, generated: no file needed.

Units are arbitrary; every metric of the table is relative to the bounding box diagonal.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from neuralmesh_tools.geometry import Faces, Points


def union_of_cells(
    x: Sequence[float], y: Sequence[float], z: Sequence[float], filled: NDArray[np.bool_]
) -> tuple[Points, Faces]:
    """Return the boundary of the filled cells of an axis-aligned grid, outward oriented.

    x, y and z are the planes of the grid, ascending; filled has one entry a cell:
    (len(x) - 1, len(y) - 1, len(z) - 1). Two filled cells that meet in an edge or a vertex only
    would make the result non-manifold: not checked.
    """
    solid = np.pad(filled, 1)
    corners: dict[tuple[int, int, int], int] = {}
    faces: list[tuple[int, int, int]] = []

    def corner(index: tuple[int, int, int]) -> int:
        return corners.setdefault(index, len(corners))

    for cell in np.argwhere(filled):
        for axis in range(3):
            for side in (0, 1):
                neighbour = cell + 1
                neighbour[axis] += 2 * side - 1
                if solid[tuple(neighbour)]:
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                steps = [(0, 0), (1, 0), (1, 1), (0, 1)]
                quad = []
                for du, dv in steps if side else reversed(steps):
                    at = cell.copy()
                    at[axis] += side
                    at[u] += du
                    at[v] += dv
                    quad.append(corner((int(at[0]), int(at[1]), int(at[2]))))
                faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    points = np.array([(x[i], y[j], z[k]) for i, j, k in corners], dtype=np.float64)
    return points, np.array(faces, dtype=np.int32)


def l_bracket() -> tuple[Points, Faces]:
    """Two plates 4 wide and 0.6 thick at a right angle: convex and concave creases, flat faces."""
    filled = np.array([[[True], [True]], [[True], [False]]])
    return union_of_cells([0, 0.6, 4], [0, 0.6, 3], [0, 2], filled)


def stepped_cube() -> tuple[Points, Faces]:
    """A unit cube without one octant: three concave creases that meet in a concave corner."""
    filled = np.ones((2, 2, 2), dtype=bool)
    filled[1, 1, 1] = False
    return union_of_cells([0, 0.5, 1], [0, 0.5, 1], [0, 0.5, 1], filled)


def thin_blade() -> tuple[Points, Faces]:
    """A knife 10 long and 3 high, 2.9 % of the diagonal thick at the back, 0.6 % at the edge."""
    points, faces = union_of_cells([0, 10], [0, 3], [-0.15, 0.15], np.ones((1, 1, 1), dtype=bool))
    points[points[:, 1] > 0, 2] *= 0.2
    return points, faces


def picture_frame(bar: float) -> tuple[Points, Faces]:
    """A square frame of genus 1, 2 wide about the origin, whose bars are `bar` wide and deep."""
    planes = [-1, bar - 1, 1 - bar, 1]
    filled = np.ones((3, 3, 1), dtype=bool)
    filled[1, 1, 0] = False
    return union_of_cells(planes, planes, [-bar / 2, bar / 2], filled)


def unit_sphere(rings: int) -> tuple[Points, Faces]:
    """A closed sphere of radius 1 about the origin: an octahedron with each edge cut in `rings`.

    It has 4 * rings**2 + 2 vertices, all of them on the sphere.
    """
    index: dict[tuple[int, int, int], int] = {}
    faces: list[tuple[int, int, int]] = []

    def vertex(at: NDArray[np.int64]) -> int:
        return index.setdefault((int(at[0]), int(at[1]), int(at[2])), len(index))

    for signs in np.array(np.meshgrid([1, -1], [1, -1], [1, -1])).reshape(3, -1).T:
        outward = int(np.prod(signs)) > 0
        for i in range(rings):
            for j in range(rings - i):
                a, b, c = (
                    np.array([p, q, rings - p - q]) for p, q in [(i, j), (i + 1, j), (i, j + 1)]
                )
                triangles = [(a, b, c)]
                if i + j < rings - 1:
                    triangles.append((b, np.array([i + 1, j + 1, rings - i - j - 2]), c))
                for triangle in triangles:
                    p, q, r = (vertex(signs * corner) for corner in triangle)
                    faces.append((p, q, r) if outward else (p, r, q))
    points = np.array(list(index), dtype=np.float64)
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    return points, np.array(faces, dtype=np.int32)
