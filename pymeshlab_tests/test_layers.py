# SPDX-License-Identifier: GPL-3.0-or-later
"""What is sampled of a document: a layer's points or surface, several layers, densities."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from documents import (
    FILTER,
    Percentage,
    Points,
    assert_refused,
    document_of,
    mesh_from,
    reconstruct,
    sphere_points,
    state_of,
    torus_mesh,
)
from numpy.typing import NDArray

pytestmark = pytest.mark.usefixtures("plugin")

POINTS, SURFACE, VISIBLE = 0, 1, 2


# ------------------------------------------------------------------------ surface of a layer


def test_surface_of_a_layer_with_few_large_faces(mesh_set: pymeshlab.MeshSet) -> None:
    mesh_set.create_cube(size=2.0)
    result = reconstruct(mesh_set, targetvertnum=800, source=SURFACE)
    assert result["vertices"] == 800
    assert mesh_set.current_mesh().label() == "Cube neural mesh"
    # 8 vertices would not carry 800. Rounded edges, of about a face's size (0.2), take 1 % away.
    volume = mesh_set.get_geometric_measures()["mesh_volume"]
    assert volume == pytest.approx(8.0, rel=0.01)


def test_surface_is_taken_with_the_layers_matrix(mesh_set: pymeshlab.MeshSet) -> None:
    mesh_set.create_sphere(radius=1.0, subdiv=4)
    matrix = np.eye(4)
    matrix[:3, :3] *= 3.0
    matrix[:3, 3] = [100.0, -50.0, 7.0]
    mesh_set.set_matrix(transformmatrix=matrix, freeze=False)
    reconstruct(mesh_set, targetvertnum=300, source=SURFACE)
    mesh = mesh_set.current_mesh()
    np.testing.assert_array_equal(mesh.transform_matrix(), np.eye(4))
    radii = np.linalg.norm(mesh.vertex_matrix() - matrix[:3, 3], axis=1)
    assert radii == pytest.approx(3.0, rel=0.02)


def test_deleted_faces_are_not_sampled() -> None:
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(torus_mesh((50.0, 0.0, 0.0)))
    document.create_sphere(radius=1.0, subdiv=4)
    document.generate_by_merging_visible_meshes(mergevertices=False, deletelayer=True)
    document.compute_selection_by_condition_per_face(condselect="x0 > 10")
    document.meshing_remove_selected_faces()
    reconstruct(document, targetvertnum=200, source=SURFACE)
    radii = np.linalg.norm(document.current_mesh().vertex_matrix(), axis=1)
    assert radii == pytest.approx(1.0, rel=0.02)


def test_uneven_vertices_make_no_difference_to_a_surface() -> None:
    # A sphere with a hundred times as many vertices on its upper half: points are drawn to it,
    # the surface is not.
    document = pymeshlab.MeshSet(verbose=False)
    document.create_sphere(radius=1.0, subdiv=4)
    document.compute_selection_by_condition_per_face(condselect="z0 > 0 && z1 > 0 && z2 > 0")
    document.meshing_surface_subdivision_midpoint(
        iterations=3, threshold=Percentage(0), selected=True
    )
    shares = []
    for source in (POINTS, SURFACE):
        document.set_current_mesh(0)
        reconstruct(document, targetvertnum=400, source=source)
        shares.append(np.mean(document.current_mesh().vertex_matrix()[:, 2] > 0))
    # 0.83 to 0.84 with five seeds: half of the vertices are those of the start, which spreads them
    # by curvature, and sparse points are drawn more often than in proportion. From a tetrahedron,
    # which learns by equation 1, 0.91 to 0.93.
    assert shares[0] == pytest.approx(0.835, abs=0.03)
    assert shares[1] == pytest.approx(0.5, abs=0.05)


def test_a_layer_without_faces_has_no_surface() -> None:
    assert_refused(
        document_of(sphere_points(100)),
        "The current layer has no faces, so it has no surface to sample: choose source=0.",
        targetvertnum=10,
        source=SURFACE,
    )


def test_a_surface_without_area_is_refused() -> None:
    document = pymeshlab.MeshSet(verbose=False)
    faces = np.array([[0, 0, 1], [2, 3, 2]], dtype=np.int32)
    document.add_mesh(pymeshlab.Mesh(sphere_points(4), faces))
    assert_refused(
        document,
        "All faces are without area: there is no surface to sample.",
        targetvertnum=10,
        source=SURFACE,
    )


def test_a_face_at_infinity_is_refused() -> None:
    points = sphere_points(4)
    points[2, 1] = np.inf
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(points, np.array([[0, 1, 2], [1, 2, 3]], dtype=np.int32)))
    assert_refused(
        document,
        "1 of 4 points have coordinates that are NaN or infinite (the first is point 2). "
        "Remove them and try again.",
        targetvertnum=4,
        source=SURFACE,
    )


# ------------------------------------------------------------------------- all visible layers


def rotation_about_z(degrees: float, offset: tuple[float, float, float]) -> NDArray[np.float64]:
    """Return the 4 by 4 matrix of a rotation about z, then a translation."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrix = np.eye(4)
    matrix[:2, :2] = [[c, -s], [s, c]]
    matrix[:3, 3] = offset
    return matrix


def add_range_map(
    document: pymeshlab.MeshSet, points: Points, matrix: NDArray[np.float64], label: str
) -> None:
    """Add points as a scanner gives them: in its own coordinates, with the matrix that aligns."""
    local = (points - matrix[:3, 3]) @ matrix[:3, :3]
    document.add_mesh(pymeshlab.Mesh(local), label)
    document.set_matrix(transformmatrix=matrix, freeze=False)


def test_two_aligned_overlapping_range_maps_give_one_mesh(bunny_array: Points) -> None:
    low, high = np.quantile(bunny_array[:, 0], [0.4, 0.6])
    document = pymeshlab.MeshSet(verbose=False)
    left, right = rotation_about_z(30, (1, 2, 3)), rotation_about_z(-70, (-5, 0.5, 0))
    add_range_map(document, bunny_array[bunny_array[:, 0] < high], left, "left")
    add_range_map(document, bunny_array[bunny_array[:, 0] > low], right, "right")
    before = state_of(document)
    result = reconstruct(document, targetvertnum=1000, source=VISIBLE)
    assert state_of(document).layers[:2] == before.layers
    assert (result["vertices"], result["components"], result["genus"]) == (1000, 1, 0)
    mesh = document.current_mesh()
    assert mesh.label() == "visible layers neural mesh"
    np.testing.assert_array_equal(mesh.transform_matrix(), np.eye(4))
    # All over the bunny, as near to it as the mesh of the bunny in one piece.
    diagonal = np.linalg.norm(np.ptp(bunny_array, axis=0))
    document.add_mesh(pymeshlab.Mesh(bunny_array), "whole")
    measured = document.get_hausdorff_distance(
        sampledmesh=3, targetmesh=2, samplevert=True, sampleface=False, samplenum=10**6
    )
    assert measured["RMS"] < 0.0012 * diagonal


def test_hidden_and_empty_layers_are_left_out() -> None:
    document = document_of(sphere_points(2000), "seen")
    document.add_mesh(pymeshlab.Mesh(sphere_points(2000) + 50.0), "hidden")
    document.set_current_mesh_visibility(False)
    document.add_mesh(pymeshlab.Mesh(sphere_points(10) - 50.0), "empty")
    document.set_selection_all()
    document.meshing_remove_selected_vertices()
    reconstruct(document, targetvertnum=100, source=VISIBLE)
    vertices = document.current_mesh().vertex_matrix()
    assert np.linalg.norm(vertices, axis=1) == pytest.approx(1.0, abs=0.05)


def test_one_visible_layer_gives_what_it_gives_as_the_current_one() -> None:
    points = sphere_points(2000)
    document = document_of(points)
    reconstruct(document, targetvertnum=100, source=VISIBLE)
    expected, _ = mesh_from(points, targetvertnum=100)
    np.testing.assert_array_equal(document.current_mesh().vertex_matrix(), expected)


def test_a_document_with_nothing_to_see_is_refused() -> None:
    document = document_of(sphere_points(100))
    document.set_current_mesh_visibility(False)
    assert_refused(document, "No visible layer has vertices.", targetvertnum=10, source=VISIBLE)


@pytest.mark.parametrize("value", [-1, 99, "Nothing"])
def test_an_unknown_source_is_refused(value: object) -> None:
    # PyMeshLab itself stops here, before the filter is asked.
    document = document_of(sphere_points(100))
    with pytest.raises(pymeshlab.InvalidEnumException):
        reconstruct(document, targetvertnum=10, source=value)


# --------------------------------------------------------------------------- density


def with_quality(points: Points, quality: NDArray[np.float64]) -> pymeshlab.MeshSet:
    """Return a document whose only layer has a quality at each vertex."""
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(points, v_scalar_array=quality), "cloud")
    return document


def test_vertices_go_where_quality_is_high() -> None:
    points = sphere_points(20000)
    document = with_quality(points, np.where(points[:, 2] > 0, 9.0, 1.0))
    reconstruct(document, targetvertnum=500, densityfromquality=True)
    # Nine of ten samples are in the upper half, where errors, which draw vertices too, are smaller.
    assert np.mean(document.current_mesh().vertex_matrix()[:, 2] > 0) > 0.7


def test_points_of_quality_0_are_as_if_they_were_not_there() -> None:
    points = np.vstack([sphere_points(2000), sphere_points(500) + 50.0])
    quality = np.repeat([1.0, 0.0], [2000, 500])
    document = with_quality(points, quality)
    reconstruct(document, targetvertnum=100, densityfromquality=True)
    vertices = document.current_mesh().vertex_matrix()
    assert np.linalg.norm(vertices, axis=1) == pytest.approx(1.0, abs=0.05)
    assert_refused(
        with_quality(points, quality),
        "targetvertnum is 2001, but there are only 2000 distinct points to draw from: at most "
        "2000 vertices are possible.",
        targetvertnum=2001,
        densityfromquality=True,
    )


def test_density_holds_on_a_surface_too(mesh_set: pymeshlab.MeshSet) -> None:
    mesh_set.create_sphere(radius=1.0, subdiv=4)
    mesh_set.compute_scalar_by_function_per_vertex(q="z > 0 ? 9 : 1")
    reconstruct(mesh_set, targetvertnum=500, source=SURFACE, densityfromquality=True)
    assert np.mean(mesh_set.current_mesh().vertex_matrix()[:, 2] > 0) > 0.7


QUALITY_CASES = [
    pytest.param(
        {7: -1.0, 30: -0.5},
        "densityfromquality: the quality of 2 of 50 vertices is negative, NaN or infinite (the "
        "first is vertex 7).",
        id="negative",
    ),
    pytest.param(
        {11: np.nan},
        "densityfromquality: the quality of 1 of 50 vertices is negative, NaN or infinite (the "
        "first is vertex 11).",
        id="nan",
    ),
    pytest.param(
        {49: np.inf},
        "densityfromquality: the quality of 1 of 50 vertices is negative, NaN or infinite (the "
        "first is vertex 49).",
        id="infinite",
    ),
    pytest.param(
        dict.fromkeys(range(50), 0.0),
        "densityfromquality: the quality of all vertices is 0, so none would be sampled.",
        id="zero",
    ),
    pytest.param(
        dict.fromkeys(range(3, 50), 0.0),
        "Only 3 distinct points: a closed surface needs at least 4.",
        id="three left",
    ),
]


@pytest.mark.parametrize(("broken", "sentence"), QUALITY_CASES)
def test_a_quality_that_is_no_density_is_refused(broken: dict[int, float], sentence: str) -> None:
    quality = np.ones(50)
    quality[list(broken)] = list(broken.values())
    assert_refused(
        with_quality(sphere_points(50), quality),
        sentence,
        targetvertnum=10,
        densityfromquality=True,
    )


def test_a_layer_without_quality_is_refused(
    mesh_set: pymeshlab.MeshSet, sample_meshes: Path
) -> None:
    mesh_set.load_new_mesh(str(sample_meshes / "bone.ply"))
    assert_refused(
        mesh_set,
        "densityfromquality: layer 'bone.ply' has no vertex quality. Compute one first.",
        targetvertnum=10,
        densityfromquality=True,
    )


def test_default_target_is_half_the_points_of_a_small_layer(plugin: Path) -> None:
    assert reconstruct(document_of(sphere_points(201)))["vertices"] == 100


def test_default_target_of_a_large_layer_is_the_general_one(plugin: Path) -> None:
    values = document_of(sphere_points(10_001)).filter_parameter_values(FILTER)
    assert values["targetvertnum"] == 5000
