# SPDX-License-Identifier: GPL-3.0-or-later
"""Points and triangles as arrays: sizes, normals, samples of a surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]  # (n, 3)
Faces = NDArray[np.int32]  # (m, 3), indices of points


def diagonal(points: Points) -> float:
    """The length of the bounding box diagonal, in the points' units."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def face_normals(points: Points, faces: Faces) -> Points:
    """Normals (m, 3) of faces, twice the face's area long."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    normals: Points = np.cross(b - a, c - a)
    return normals


def vertex_normals(points: Points, faces: Faces) -> Points:
    """Area-weighted unit normals (n, 3) of vertices."""
    normals = np.zeros_like(points)
    of_faces = face_normals(points, faces)
    for k in range(3):
        np.add.at(normals, faces[:, k], of_faces)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    return normals


def sample_surface(
    points: Points,
    faces: Faces,
    count: int,
    generator: np.random.Generator,
    density: NDArray[np.float64] | float = 1.0,
) -> tuple[Points, Points]:
    """Draw points (count, 3) of a surface, and the unit normals (count, 3) of their faces.

    density: of the points by area, that of all faces or of each (m,), on any scale.
    """
    normals = face_normals(points, faces)
    doubled_area = np.linalg.norm(normals, axis=1)
    weight = doubled_area * density
    chosen = generator.choice(len(faces), size=count, p=weight / weight.sum())
    root, along = np.sqrt(generator.random(count))[:, None], generator.random(count)[:, None]
    a, b, c = (points[faces[chosen, k]] for k in range(3))
    drawn = (1 - root) * a + root * (1 - along) * b + root * along * c
    return drawn, normals[chosen] / doubled_area[chosen, None]
