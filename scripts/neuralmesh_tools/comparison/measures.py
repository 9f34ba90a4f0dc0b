# SPDX-License-Identifier: GPL-3.0-or-later
"""What a result is worth: distances both ways, topology, and shape of faces.

Distances are in units of the input. "To the mesh" is from the reference's points to the result,
"to the reference" from points drawn on the result, uniformly by area, and from its vertices.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from neuralmesh_tools.comparison.clouds import SEED, Cloud, Reference
from neuralmesh_tools.geometry import Faces, Points, sample_surface
from neuralmesh_tools.metrics import point_distances, shape, topology, valences

MESH_SAMPLES = 50_000
LARGEST_VALENCE = 12


@dataclass(frozen=True)
class Measured:
    """values: plain numbers by name. face_error (m,): RMS distance of each face to the reference.

    valence_shares: per cent of vertices of each valence; the last counts larger ones too.
    """

    values: dict[str, Any]
    face_error: NDArray[np.float32]
    valence_shares: list[float]


def error_of(
    points: Points, faces: Faces, cloud: Cloud, surface: tuple[Points, Faces] | None
) -> float:
    """The RMS distance, both ways taken together, of a mesh to its reference."""
    reference = Reference(cloud, surface)
    drawn, _ = sample_surface(points, faces, MESH_SAMPLES, np.random.default_rng(SEED))
    return _rms_both(point_distances(reference.probes, points, faces), reference.distances(drawn))


def measure(
    points: Points,
    faces: Faces,
    cloud: Cloud,
    surface: tuple[Points, Faces] | None,
    threshold: float,
) -> Measured:
    """Measure a mesh against a surface, or against the cloud if that is None.

    threshold: the distance, in units of the input, within which the F-score counts a point.
    """
    reference = Reference(cloud, surface)
    drawn, normals = sample_surface(points, faces, MESH_SAMPLES, np.random.default_rng(SEED))
    to_mesh = point_distances(reference.probes, points, faces)
    to_reference = reference.distances(drawn)
    corner_error = reference.distances(points[np.unique(faces)])
    recall, precision = np.mean(to_mesh <= threshold), np.mean(to_reference <= threshold)
    counted = valences(faces)
    histogram = np.bincount(np.minimum(counted, LARGEST_VALENCE), minlength=LARGEST_VALENCE + 1)
    values = {
        **shape(points, faces),
        "rms": _rms_both(to_mesh, to_reference),
        "rms_to_mesh": _rms(to_mesh),
        "rms_to_reference": _rms(to_reference),
        "hausdorff_to_mesh": float(to_mesh.max()),
        "hausdorff_to_reference": float(max(to_reference.max(), corner_error.max())),
        "chamfer": float(to_mesh.mean() + to_reference.mean()) / 2,
        "f_score": float(200 * precision * recall / max(precision + recall, 1e-300)),
        "normal_consistency": _normal_consistency(drawn, normals, reference),
        "missed": float(100 * np.mean(to_mesh > reference.reach)),
        "far_from_points": float(100 * np.mean(reference.far_from_points(drawn))),
        **topology(points, faces),
    }
    shares = (100 * histogram / len(counted)).tolist()
    return Measured(values, _face_error(points, faces, reference), shares)


def _face_error(points: Points, faces: Faces, reference: Reference) -> NDArray[np.float32]:
    """RMS distance of each face, from three points in it whose mean is exact for quadratics.

    Not from its corners: whether these are on the points says little of the surface between them.
    """
    corners = points[faces]
    squares = np.zeros(len(faces))
    for weights in np.full((3, 3), 1 / 6) + np.eye(3) / 2:
        squares += reference.distances(np.einsum("c,mcx->mx", weights, corners)) ** 2
    return np.sqrt(squares / 3).astype("f4")


def _rms(distances: NDArray[np.float64]) -> float:
    return float(np.sqrt(np.mean(distances**2)))


def _rms_both(one_way: NDArray[np.float64], other_way: NDArray[np.float64]) -> float:
    return float(np.hypot(_rms(one_way), _rms(other_way)) / np.sqrt(2))


def _normal_consistency(drawn: Points, normals: Points, reference: Reference) -> float:
    """Mean cosine, sign dropped, between normals of nearest points, both ways, in per cent."""
    _, there = KDTree(reference.probes).query(drawn)
    _, back = KDTree(drawn).query(reference.probes)
    cosines = [
        np.abs(np.sum(normals * reference.normals[there], axis=1)).mean(),
        np.abs(np.sum(reference.normals * normals[back], axis=1)).mean(),
    ]
    return float(100 * np.mean(cosines))
