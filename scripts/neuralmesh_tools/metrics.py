# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh is worth: distances to the reference both ways, topology, and shape of faces.

Distances are exact point-to-triangle distances (MeshLab's closest-point grid) of points drawn
uniformly by area, in per cent of the reference's bounding box diagonal; the worst distance also
looks at all vertices. Genus, components and self-intersections are MeshLab's; edges, angles and
valences are counted here.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pymeshlab
from numpy.typing import NDArray

from neuralmesh_tools.geometry import Faces, Points, diagonal, sample_surface
from neuralmesh_tools.layers import document_of

DISTANCE_SAMPLES = 100_000
SAMPLING_SEED = 20030512


def measure(
    points: Points, faces: Faces, reference_points: Points, reference_faces: Faces
) -> dict[str, Any]:
    """All metrics of a mesh as plain numbers; a genus of None means it has none (see topology)."""
    return {
        **distances(points, faces, reference_points, reference_faces),
        **topology(points, faces),
        **shape(points, faces),
    }


def distances(
    points: Points, faces: Faces, reference_points: Points, reference_faces: Faces
) -> dict[str, float]:
    """RMS and worst distance both ways, in per cent of the reference's diagonal."""
    percent = 100 / diagonal(reference_points)
    there = _sampled_distances(reference_points, reference_faces, points, faces) * percent
    back = _sampled_distances(points, faces, reference_points, reference_faces) * percent
    return {
        "rms_to_mesh": float(np.sqrt(np.mean(there[:DISTANCE_SAMPLES] ** 2))),
        "rms_to_surface": float(np.sqrt(np.mean(back[:DISTANCE_SAMPLES] ** 2))),
        "max_to_mesh": float(there.max()),
        "max_to_surface": float(back.max()),
    }


def _sampled_distances(
    points: Points, faces: Faces, target_points: Points, target_faces: Faces
) -> NDArray[np.float64]:
    """Distances to the target of DISTANCE_SAMPLES surface points, then of all vertices in use."""
    generator = np.random.default_rng(SAMPLING_SEED)
    drawn, _ = sample_surface(points, faces, DISTANCE_SAMPLES, generator)
    probes = np.vstack([drawn, points[np.unique(faces)]])
    return point_distances(probes, target_points, target_faces)


def point_distances(
    probes: Points, target_points: Points, target_faces: Faces
) -> NDArray[np.float64]:
    """Unsigned distances (n,) of probes (n, 3) to the nearest point of a triangle mesh.

    In the probes' units, with the seven digits of the filter's single-precision answer.
    """
    document = document_of(target_points, target_faces)
    document.add_mesh(pymeshlab.Mesh(vertex_matrix=probes))
    # Beyond maxdist the filter answers maxdist: put it out of reach of any pair of points.
    reach = 2 * diagonal(np.vstack([probes, target_points]))
    document.compute_scalar_by_distance_from_another_mesh_per_vertex(
        measuremesh=1, refmesh=0, signeddist=False, maxdist=pymeshlab.PureValue(reach)
    )
    found: NDArray[np.float64] = document.mesh(1).vertex_scalar_array().copy()
    return found


def topology(points: Points, faces: Faces) -> dict[str, Any]:
    """Counts of a mesh; genus is None where it is undefined: not two-manifold or not closed.

    Self-intersecting faces, components and genus are MeshLab's. Its count of non-manifold edges is
    of face sides (4 for one edge of four faces), so edges are counted here.
    """
    document = document_of(points, faces)
    found = document.get_topological_measures()
    document.compute_selection_by_self_intersections_per_face()
    _, faces_at_edge = edges(faces)
    closed = found["is_mesh_two_manifold"] and found["boundary_edges"] == 0
    return {
        "self_intersecting": document.current_mesh().selected_face_number(),
        "boundary_edges": int(np.sum(faces_at_edge == 1)),
        "non_manifold_edges": int(np.sum(faces_at_edge > 2)),
        "non_manifold_vertices": found["non_two_manifold_vertices"],
        "components": found["connected_components_number"],
        "genus": found["genus"] if closed else None,
    }


def shape(points: Points, faces: Faces) -> dict[str, float]:
    """Vertices in use, faces, angles in degrees and valences (shares in per cent)."""
    smallest = smallest_angles(points, faces)
    valence = valences(faces)
    return {
        "vertices": len(valence),
        "faces": len(faces),
        "min_angle": float(smallest.min()),
        "angle_1_percent": float(np.percentile(smallest, 1)),
        "valence_6": float(100 * np.mean(valence == 6)),
        "valence_5_to_7": float(100 * np.mean((valence >= 5) & (valence <= 7))),
    }


def smallest_angles(points: Points, faces: Faces) -> NDArray[np.float64]:
    """The smallest angle (m,) of each face, in degrees; 0 for a face without area."""
    corners = points[faces]
    angles = []
    for k in range(3):
        u = corners[:, (k + 1) % 3] - corners[:, k]
        v = corners[:, (k + 2) % 3] - corners[:, k]
        sine = np.linalg.norm(np.cross(u, v), axis=1)
        angles.append(np.degrees(np.arctan2(sine, np.sum(u * v, axis=1))))
    least: NDArray[np.float64] = np.min(angles, axis=0)
    return least


def edges(faces: Faces) -> tuple[NDArray[np.int32], NDArray[np.int64]]:
    """The edges (k, 2) of a mesh as pairs of vertex ids, and the number of faces (k,) at each."""
    sides = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)


def valences(faces: Faces) -> NDArray[np.int64]:
    """The number of neighbours of each vertex in use, in order of vertex id."""
    counts = np.bincount(edges(faces)[0].ravel())
    return counts[counts > 0]
