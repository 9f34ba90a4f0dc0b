# SPDX-License-Identifier: GPL-3.0-or-later
"""What the network grows from, and that its topology stays to the end."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from documents import (
    IMPLICIT,
    Points,
    assert_refused,
    document_of,
    mesh_from,
    reconstruct,
    sphere_points,
    torus_mesh,
)

pytestmark = pytest.mark.usefixtures("plugin")

A_LAYER = 3
FROM_THE_DATA = 4
LEARNED = 1


def torus_points(count: int = 20000) -> Points:
    """Return random points on a torus of radii 2 and 1, not uniform, shape (count, 3)."""
    a, b = np.random.default_rng(1).uniform(0, 2 * np.pi, (2, count))
    ring = 2 + np.cos(b)
    return np.column_stack([ring * np.cos(a), ring * np.sin(a), np.sin(b)])


def cloud_and_start(points: Points, start: pymeshlab.Mesh) -> pymeshlab.MeshSet:
    """Return a document: a cloud, which is current, and layer 1 to start from."""
    document = document_of(points)
    document.add_mesh(start, "start")
    document.set_current_mesh(0)
    return document


@pytest.mark.parametrize("solid", [1, 2])
def test_solids_give_meshes_of_their_own(bunny_array: Points, solid: int) -> None:
    usual, _ = mesh_from(bunny_array, targetvertnum=300)
    document = document_of(bunny_array)
    result = reconstruct(document, targetvertnum=300, startmesh=solid)
    assert (result["vertices"], result["genus"], result["components"]) == (300, 0, 1)
    assert not np.array_equal(document.current_mesh().vertex_matrix(), usual)


@pytest.mark.parametrize(("solid", "vertices"), [("Octahedron", 6), ("Icosahedron", 12)])
def test_no_target_is_smaller_than_the_solid(solid: str, vertices: int) -> None:
    document = document_of(sphere_points(100))
    assert_refused(
        document,
        f"targetvertnum is {vertices - 1}, fewer than the {vertices} vertices of the starting "
        "mesh.",
        targetvertnum=vertices - 1,
        startmesh=solid,
    )
    assert reconstruct(document, targetvertnum=vertices, startmesh=solid)["vertices"] == vertices


@pytest.mark.parametrize("how", [{"topology": LEARNED}, {"startmesh": FROM_THE_DATA}])
def test_a_torus_from_its_points_alone_has_genus_1(how: dict[str, int]) -> None:
    document = document_of(torus_points())
    result = reconstruct(document, targetvertnum=1000, **how)
    assert (result["vertices"], result["faces"]) == (1000, 2000)  # Euler, genus 1
    assert (result["genus"], result["components"]) == (1, 1)
    assert document.get_topological_measures()["is_mesh_two_manifold"]


def test_two_spheres_from_their_points_alone_are_two_components() -> None:
    points = np.vstack([sphere_points(4000), sphere_points(4000) + np.array([3, 0, 0])])
    result = reconstruct(document_of(points), targetvertnum=600, topology=LEARNED)
    assert (result["vertices"], result["genus"], result["components"]) == (600, 0, 2)
    assert result["coverage"] == 1
    assert result["unsupported_area"] == 0


def test_a_membrane_is_told() -> None:
    # Half a sphere closed by a disc, which is a third of the whole.
    half = sphere_points(12000)
    half = half[half[:, 2] > 0]
    result = reconstruct(document_of(half), targetvertnum=1000)
    assert 0.25 < result["unsupported_area"] < 0.35
    assert result["coverage"] > 0.999


def test_a_torus_from_a_torus_layer_has_genus_1() -> None:
    document = cloud_and_start(torus_points(), torus_mesh())
    result = reconstruct(document, targetvertnum=1000, startmesh=A_LAYER, startlayer=1)
    assert (result["vertices"], result["faces"]) == (1000, 2000)  # Euler, genus 1
    assert (result["genus"], result["components"]) == (1, 1)
    measured = document.get_topological_measures()
    assert measured["genus"] == 1
    assert measured["is_mesh_two_manifold"]
    assert measured["boundary_edges"] == 0
    # The diagonal is 8.7. A handle in the wrong place would bridge a hole 2 wide.
    assert result["max_error"] < 0.2
    assert result["rms_error"] < 0.03


def test_a_torus_expression_from_a_torus_layer_has_genus_1(mesh_set: pymeshlab.MeshSet) -> None:
    mesh_set.add_mesh(torus_mesh(major=0.6, minor=0.3))
    result = mesh_set.apply_filter(
        IMPLICIT,
        expr="(sqrt(x*x + y*y) - 0.6)^2 + z*z - 0.09",
        targetvertnum=1000,
        startmesh=A_LAYER,
        startlayer=0,
    )
    assert result["genus"] == 1
    assert mesh_set.get_topological_measures()["genus"] == 1
    vertices = mesh_set.current_mesh().vertex_matrix()
    tube = np.hypot(np.hypot(vertices[:, 0], vertices[:, 1]) - 0.6, vertices[:, 2])
    # The tube's faces span about 0.07: vertices stand out by their sagitta, 0.07^2 / 2 / 0.3 / 3.
    assert np.sqrt(np.mean((tube - 0.3) ** 2)) < 0.003


def test_several_components_and_their_genera_stay() -> None:
    # A torus beside a ball, grown from a torus and an octahedron, in one layer.
    aside = np.array([6.0, 0.0, 0.0])
    points = np.vstack([torus_points(), sphere_points(8000) + aside])
    torus = torus_mesh()
    ball = document_of(sphere_points(1))
    ball.create_octahedron()
    octahedron = ball.current_mesh()
    start = pymeshlab.Mesh(
        np.vstack([torus.vertex_matrix(), octahedron.vertex_matrix() + aside]),
        np.vstack([torus.face_matrix(), octahedron.face_matrix() + torus.vertex_number()]),
    )
    document = cloud_and_start(points, start)
    result = reconstruct(document, targetvertnum=1200, startmesh=A_LAYER, startlayer=1)
    assert (result["genus"], result["components"]) == (1, 2)
    assert result["faces"] == 2 * 1200 - 4  # V - E + F = 0 + 2
    measured = document.get_topological_measures()
    assert measured["connected_components_number"] == 2
    assert measured["is_mesh_two_manifold"]


def test_the_starting_layers_matrix_is_baked_in() -> None:
    matrix = np.diag([0.01, 0.01, 0.01, 1.0])
    matrix[:3, 3] = [-7.0, 3.0, 1.0]
    local = torus_mesh()
    vertices = (local.vertex_matrix() - matrix[:3, 3]) / 0.01
    document = cloud_and_start(torus_points(), pymeshlab.Mesh(vertices, local.face_matrix()))
    document.set_current_mesh(1)
    document.set_matrix(transformmatrix=matrix, freeze=False)
    document.set_current_mesh(0)
    result = reconstruct(document, targetvertnum=500, startmesh=A_LAYER, startlayer=1)
    assert result["genus"] == 1
    assert result["max_error"] < 0.4
    np.testing.assert_array_equal(document.mesh(1).vertex_matrix(), vertices)


def test_a_mirrored_starting_layer_gives_a_surface_that_faces_outwards() -> None:
    document = cloud_and_start(torus_points(), torus_mesh())
    document.set_current_mesh(1)
    document.set_matrix(transformmatrix=np.diag([1.0, 1.0, -1.0, 1.0]), freeze=False)
    document.set_current_mesh(0)
    reconstruct(document, targetvertnum=500, startmesh=A_LAYER, startlayer=1)
    volume = document.get_geometric_measures()["mesh_volume"]
    assert volume == pytest.approx(4 * np.pi**2, rel=0.02)  # 2 pi^2 R r^2


def test_snapshots_start_at_the_starting_layer() -> None:
    document = cloud_and_start(torus_points(), torus_mesh())
    parameters = {"startmesh": A_LAYER, "startlayer": 1, "targetvertnum": 300}
    assert_refused(
        document,
        "snapshots names 95 vertices, fewer than the 96 vertices of the starting mesh.",
        snapshots="95,200",
        **parameters,
    )
    reconstruct(document, snapshots="96,200", **parameters)
    counts = [(mesh.vertex_number(), mesh.face_number()) for mesh in list(document)[2:]]
    assert counts == [(96, 192), (200, 400), (300, 600)]


def refused_start(start: pymeshlab.Mesh, sentence: str, **parameters: object) -> None:
    document = cloud_and_start(sphere_points(500), start)
    settings = {"targetvertnum": 200, "startmesh": A_LAYER, "startlayer": 1} | parameters
    assert_refused(document, sentence, **settings)


def test_starting_layers_that_are_no_closed_two_manifold_are_refused() -> None:
    torus = torus_mesh()
    points, faces = torus.vertex_matrix(), torus.face_matrix()
    refused_start(pymeshlab.Mesh(points), "The starting layer has no faces.")
    refused_start(
        pymeshlab.Mesh(points, faces[1:]),
        "The starting layer is not closed: 3 edges belong to one face only. Close its holes, or "
        "merge its close vertices.",
    )
    refused_start(
        pymeshlab.Mesh(points, np.vstack([faces, faces[:1]])),
        "The starting layer is not two-manifold: 3 edges belong to more than two faces.",
    )
    refused_start(
        pymeshlab.Mesh(points, np.vstack([faces, [[5, 5, 6]]]).astype(np.int32)),
        "The starting layer is not two-manifold: 1 face names a vertex twice.",
    )
    broken = points.copy()
    broken[3, 0] = np.nan
    refused_start(
        pymeshlab.Mesh(broken, faces),
        "The starting layer has coordinates that are NaN, infinite or too large.",
    )


def test_a_starting_layer_with_more_vertices_than_the_target_is_refused() -> None:
    refused_start(
        torus_mesh(),
        "targetvertnum is 95, fewer than the 96 vertices of the starting mesh.",
        targetvertnum=95,
    )


def test_a_starting_layer_that_is_not_there_is_refused(mesh_set: pymeshlab.MeshSet) -> None:
    assert_refused(
        mesh_set,
        "startmesh is a layer, but startlayer names none.",
        IMPLICIT,
        targetvertnum=100,
        startmesh=A_LAYER,
    )


def half_sphere(count: int = 12000) -> Points:
    """Return the points of a unit sphere above z = 0, about half of count of them."""
    points = sphere_points(count)
    upper: Points = points[points[:, 2] > 0]
    return upper


def tube(count: int = 8000) -> Points:
    """Return points of an open tube of radius 1 and length 3, shape (count, 3)."""
    angle, height = np.random.default_rng(1).uniform(0, 1, (2, count))
    angle *= 2 * np.pi
    return np.column_stack([np.cos(angle), np.sin(angle), 3 * height])


@pytest.mark.parametrize(("points", "loops"), [(half_sphere(), 1), (tube(), 2)])
def test_open_boundaries_are_where_the_points_end(points: Points, loops: int) -> None:
    result = reconstruct(document_of(points), targetvertnum=1000, topology=LEARNED, boundaries=1)
    assert (result["vertices"], result["genus"], result["components"]) == (1000, 0, 1)
    assert result["boundary_loops"] == loops
    assert result["coverage"] > 0.999
    assert result["unsupported_area"] < 0.001


@pytest.mark.parametrize("points", [half_sphere(), tube()])
def test_closed_boundaries_are_filled(points: Points) -> None:
    document = document_of(points)
    result = reconstruct(document, targetvertnum=1000, topology=LEARNED)
    assert (result["vertices"], result["faces"]) == (1000, 1996)  # Euler, genus 0, closed
    assert (result["boundary_loops"], result["self_intersections"]) == (0, 0)
    assert result["coverage"] > 0.999
    assert document.get_topological_measures()["is_mesh_two_manifold"]


def test_holes_up_to_the_maximal_size_are_closed() -> None:
    points = sphere_points(20000)
    # A hole of 53 degrees around the pole, 0.89 of the radius 1 wide: a quarter of the diagonal.
    pierced = points[points[:, 2] < np.cos(np.arcsin(0.445))]
    settings = {"targetvertnum": 600, "topology": LEARNED, "boundaries": 1}
    wide = {"maxholesize": pymeshlab.PercentageValue(40)}
    assert reconstruct(document_of(pierced), **settings)["boundary_loops"] == 1
    assert reconstruct(document_of(pierced), **settings, **wide)["boundary_loops"] == 0


def test_a_negative_hole_size_is_refused() -> None:
    assert_refused(
        document_of(sphere_points(1000)),
        "maxholesize must be at least 0, not -1.",
        maxholesize=pymeshlab.PureValue(-1),
    )
