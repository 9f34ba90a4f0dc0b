# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the points lie, how large they are and what matrix their layer has make no difference.

Growth is chaotic: a sample that falls nearly halfway between two vertices goes to the other one if
its last bit differs, and from there on the meshes are different, though equally good. So these
tests compare vertices only where the input can be moved without any rounding: points on a grid of
2^-20 (offsets leave them exact), scales that are powers of two, rotations that permute the axes.
With any other matrix they ask whether the result lies where the transformed points do.
"""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from documents import Points, document_of, mesh_from, reconstruct, sphere_points
from numpy.typing import NDArray

pytestmark = pytest.mark.usefixtures("plugin")

UTM_OFFSET = np.array([500_000.0, 4_500_000.0, 100.0])
TARGET = 1000


def on_grid(points: Points) -> Points:
    """Round to multiples of 2^-20: exact in double precision even with seven digits before it."""
    return np.round(points * 2.0**20) / 2.0**20


def diagonal_of(points: Points) -> float:
    """Return the length of the bounding box's diagonal."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def with_matrix(points: Points, matrix: NDArray[np.float64]) -> pymeshlab.MeshSet:
    """Return a document whose layer holds the points and, apart from them, the 4 by 4 matrix."""
    document = document_of(points)
    document.set_matrix(transformmatrix=matrix, freeze=False)
    np.testing.assert_array_equal(document.current_mesh().transform_matrix(), matrix)
    np.testing.assert_array_equal(document.current_mesh().vertex_matrix(), points)
    return document


def test_points_at_utm_coordinates_give_the_mesh_of_centred_ones(bunny_array: Points) -> None:
    points = on_grid(bunny_array)
    far = points + UTM_OFFSET
    np.testing.assert_array_equal(far - UTM_OFFSET, points)  # no rounding
    near_vertices, near_faces = mesh_from(points, targetvertnum=TARGET)
    far_vertices, far_faces = mesh_from(far, targetvertnum=TARGET)
    np.testing.assert_array_equal(far_faces, near_faces)
    tolerance = 1e-6 * diagonal_of(points)
    np.testing.assert_allclose(far_vertices - UTM_OFFSET, near_vertices, rtol=0, atol=tolerance)


@pytest.mark.parametrize("exponent", [-300, -20, 20, 300])
def test_size_makes_no_difference(exponent: int) -> None:
    points = sphere_points(2000)
    scale = 2.0**exponent
    vertices, faces = mesh_from(points, targetvertnum=200)
    scaled_vertices, scaled_faces = mesh_from(points * scale, targetvertnum=200)
    np.testing.assert_array_equal(scaled_faces, faces)
    np.testing.assert_array_equal(scaled_vertices, vertices * scale)


def test_layer_matrix_is_baked_into_the_result_exactly(bunny_array: Points) -> None:
    points = on_grid(bunny_array)
    # x to y to z to x, twice the size, moved: all without rounding.
    matrix = np.array([[0, 0, 2, 10], [2, 0, 0, -20], [0, 2, 0, 5], [0, 0, 0, 1]], dtype=float)
    document = with_matrix(points, matrix)
    reconstruct(document, targetvertnum=TARGET)
    mesh = document.current_mesh()
    np.testing.assert_array_equal(mesh.transform_matrix(), np.eye(4))
    transformed = points @ matrix[:3, :3].T + matrix[:3, 3]
    vertices, faces = mesh_from(transformed, targetvertnum=TARGET)
    np.testing.assert_array_equal(mesh.vertex_matrix(), vertices)
    np.testing.assert_array_equal(mesh.face_matrix(), faces)


def oblique_matrix() -> NDArray[np.float64]:
    """Return a rotation about (1, 2, 3) by 40 degrees, times 3, followed by a translation."""
    axis = np.array([1.0, 2.0, 3.0]) / np.sqrt(14.0)
    cross = np.cross(np.eye(3), axis)
    angle = np.radians(40.0)
    rotation = np.eye(3) - np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    matrix = np.eye(4)
    matrix[:3, :3] = 3.0 * rotation
    matrix[:3, 3] = [100.0, -50.0, 7.0]
    return matrix


def test_rotated_scaled_and_moved_layer_gives_its_surface_in_place(bunny_array: Points) -> None:
    matrix = oblique_matrix()
    document = with_matrix(bunny_array, matrix)
    reconstruct(document, targetvertnum=TARGET)
    vertices = np.array(document.current_mesh().vertex_matrix())
    np.testing.assert_array_equal(document.current_mesh().transform_matrix(), np.eye(4))
    np.testing.assert_array_equal(document.mesh(0).vertex_matrix(), bunny_array)
    np.testing.assert_array_equal(document.mesh(0).transform_matrix(), matrix)
    # Taken back, the vertices lie on the bunny as it was loaded: nearly all of them much nearer to
    # its points than to each other (their edges are about 3 % of the diagonal).
    back = np.linalg.solve(matrix[:3, :3], (vertices - matrix[:3, 3]).T).T
    nearest = np.array([np.min(np.linalg.norm(bunny_array - v, axis=1)) for v in back])
    assert np.quantile(nearest, 0.9) < 0.01 * diagonal_of(bunny_array)
    np.testing.assert_allclose(np.ptp(back, axis=0), np.ptp(bunny_array, axis=0), rtol=0.05)


def test_mirrored_layer_gives_a_surface_that_faces_outwards() -> None:
    document = with_matrix(sphere_points(2000), np.diag([-1.0, 1.0, 1.0, 1.0]))
    reconstruct(document, targetvertnum=200)
    # The fit lays the faces on the sphere in the mean, so they enclose the ball's volume; the sign
    # is what a mirrored layer could turn.
    ball = 4 / 3 * np.pi
    assert document.get_geometric_measures()["mesh_volume"] == pytest.approx(ball, rel=0.01)


def test_deleted_vertices_are_not_sampled() -> None:
    far_away = np.full((500, 3), 50.0) + sphere_points(500)
    document = document_of(np.vstack([far_away, sphere_points(500)]))
    document.compute_selection_by_condition_per_vertex(condselect="x > 10")
    document.meshing_remove_selected_vertices()
    result = reconstruct(document, targetvertnum=100)
    assert result["vertices"] == 100
    vertices = document.current_mesh().vertex_matrix()
    assert np.linalg.norm(vertices, axis=1).max() < 1.1


@pytest.mark.parametrize("target", [1500, 2900, 3000])
def test_a_target_close_to_the_number_of_points_is_reached(target: int) -> None:
    document = document_of(sphere_points(3000))
    result = reconstruct(document, targetvertnum=target)
    assert result["vertices"] == document.current_mesh().vertex_number() == target
    assert result["reached_target"] is True
    assert document.get_topological_measures()["is_mesh_two_manifold"]
    radii = np.linalg.norm(document.current_mesh().vertex_matrix(), axis=1)
    # At 3,000 vertices an edge is 0.07 long: a vertex off by half of that would be misplaced.
    assert np.abs(radii - 1).max() < 0.035


def test_growth_that_comes_to_a_stop_reaches_its_target_all_the_same(bunny_array: Points) -> None:
    # Removing every vertex that did not win within 2n samples, growth by one in 100 samples has its
    # balance far below 400 vertices.
    document = document_of(bunny_array)
    result = reconstruct(document, targetvertnum=400, inactivityfactor=2)
    assert result["reached_target"] is True
    vertices = document.current_mesh().vertex_number()
    assert result["vertices"] == vertices == 400
    measured = document.get_topological_measures()
    assert measured["faces_number"] == 2 * vertices - 4
    assert measured["is_mesh_two_manifold"]
    assert measured["boundary_edges"] == 0
