# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of implicit and parametric surfaces, made in an empty document."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from documents import (
    FILTER,
    IMPLICIT,
    PARAMETRIC,
    assert_refused,
    document_of,
    sphere_points,
    state_of,
    valences_of,
)

pytestmark = pytest.mark.usefixtures("plugin")


def test_an_implicit_sphere_is_round_with_even_valences(mesh_set: pymeshlab.MeshSet) -> None:
    result = mesh_set.apply_filter(IMPLICIT, expr="x*x+y*y+z*z-0.5", targetvertnum=1000)
    assert (result["vertices"], result["genus"], result["reached_target"]) == (1000, 0, True)
    mesh = mesh_set.current_mesh()
    assert mesh.label() == "implicit surface neural mesh"
    radii = np.linalg.norm(mesh.vertex_matrix(), axis=1) / np.sqrt(0.5)
    assert np.sqrt(np.mean((radii - 1) ** 2)) < 0.005
    valences = valences_of(mesh.face_matrix(), 1000) / 1000
    # As the defaults give on points (test_growth.cpp).
    assert valences[6] >= 0.5
    assert valences[5:8].sum() >= 0.985


def test_a_parametric_sphere_is_round_with_even_valences(mesh_set: pymeshlab.MeshSet) -> None:
    result = mesh_set.apply_filter(PARAMETRIC, targetvertnum=1000)
    assert (result["vertices"], result["genus"], result["reached_target"]) == (1000, 0, True)
    mesh = mesh_set.current_mesh()
    assert mesh.label() == "parametric surface neural mesh"
    radii = np.linalg.norm(mesh.vertex_matrix(), axis=1)
    assert np.sqrt(np.mean((radii - 1) ** 2)) < 0.005
    valences = valences_of(mesh.face_matrix(), 1000) / 1000
    assert valences[6] >= 0.5
    assert valences[5:8].sum() >= 0.985


def test_the_implicit_surface_is_where_meshlabs_own_filter_finds_it(
    mesh_set: pymeshlab.MeshSet,
) -> None:
    expression = "x*x + 2*y*y + 3*z*z + x*y*z - 0.4*x - 0.5"
    mesh_set.create_implicit_surface(expr=expression, voxelsize=0.02)
    own = mesh_set.current_mesh_id()
    mesh_set.apply_filter(IMPLICIT, expr=expression, targetvertnum=1000)
    measured = mesh_set.get_hausdorff_distance(
        sampledmesh=own,
        targetmesh=mesh_set.current_mesh_id(),
        samplevert=True,
        sampleface=False,
        samplenum=10**6,
    )
    # Marching cubes are off by some 0.02^2, which is 0.02 % of the diagonal, 1,000 vertices by
    # 0.07 %.
    assert measured["RMS"] < 0.0015 * measured["diag_mesh_0"]


def test_a_surface_that_leaves_the_box_is_closed_there(mesh_set: pymeshlab.MeshSet) -> None:
    # A cylinder along z, cut by the box at both ends: the network spans lids.
    result = mesh_set.apply_filter(IMPLICIT, expr="x*x + y*y - 0.25", targetvertnum=500)
    assert result["boundary_loops"] == 0
    assert mesh_set.get_topological_measures()["boundary_edges"] == 0


@pytest.mark.parametrize("filter_name", [IMPLICIT, PARAMETRIC])
def test_same_seed_gives_the_same_mesh_and_layers_stay_as_they_are(filter_name: str) -> None:
    document = document_of(sphere_points(10))
    before = state_of(document)
    meshes = []
    for seed in (3, 3, 4):
        document.apply_filter(filter_name, targetvertnum=200, randomseed=seed)
        meshes.append(np.array(document.current_mesh().vertex_matrix()))
    assert state_of(document).layers[:1] == before.layers
    np.testing.assert_array_equal(meshes[0], meshes[1])
    assert not np.array_equal(meshes[0], meshes[2])


@pytest.mark.parametrize("filter_name", [IMPLICIT, PARAMETRIC])
def test_snapshots_are_layers_here_too(filter_name: str, mesh_set: pymeshlab.MeshSet) -> None:
    mesh_set.apply_filter(filter_name, targetvertnum=200, snapshots="20,100")
    assert [mesh.vertex_number() for mesh in mesh_set] == [20, 100, 200]


def test_parameters_are_those_of_the_reconstruction_but_for_what_is_sampled() -> None:
    document = document_of(sphere_points(10))
    common = set(document.filter_parameter_values(FILTER)) - {
        "source",
        "pointfile",
        "densityfromquality",
        "transferattributes",
    }
    box = {"minx", "miny", "minz", "maxx", "maxy", "maxz"}
    ranges = {"minu", "maxu", "minv", "maxv"}
    assert set(document.filter_parameter_values(IMPLICIT)) == common | {"expr"} | box
    assert set(document.filter_parameter_values(PARAMETRIC)) == common | set("xyz") | ranges


NO_SURFACE = (
    "No surface was found in the box: expr passes through zero nowhere that a grid of some 64 x 64 "
    "x 64 cubes shows. If the surface is smaller than a cube, make the box fit it."
)
DIGITS = ", by more than the seven digits that the host keeps."
FINITE = (
    "min{0} and max{0} must be finite, and so must their difference; numbers of more than about "
    "10^38 are none for the host."
)

IMPLICIT_CASES = [
    (
        {"expr": "x*x + y*y + w"},
        'expr does not parse: Unexpected token "w" found at position 12.',
    ),
    ({"expr": "(x + y"}, "expr does not parse: Missing parenthesis at position 6."),
    ({"expr": " "}, "expr is empty."),
    ({"expr": "x, y"}, "expr must be one expression, not 2 separated by commas."),
    (
        {"expr": "x*x + y*y + z*z + 1"},
        NO_SURFACE,
    ),
    (
        {"minx": 1, "maxx": 2},
        NO_SURFACE,
    ),
    (
        {"expr": "log(x) + y + z"},
        "expr is not finite at (-1, -1, -1), which is in the box.",
    ),
    ({"miny": 1, "maxy": 1}, f"The box is empty: miny must be below maxy{DIGITS}"),
    (
        {"minx": 1, "maxx": 1.0000000001},
        f"The box is empty: minx must be below maxx{DIGITS}",
    ),
    ({"maxz": np.nan}, FINITE.format("z")),
    ({"minz": -1e100, "maxz": 1e100}, FINITE.format("z")),
    (
        {"expr": "x + y", "topology": 0},
        "All points lie on a plane: a closed surface cannot be fitted to them. Use topology=1, "
        "which makes a sheet of them.",
    ),
    ({"targetvertnum": 3}, "targetvertnum must be at least 4, not 3."),
]

PARAMETRIC_CASES = [
    ({"y": "u +* v"}, 'y does not parse: Unexpected operator "*" found at position 3.'),
    ({"z": ""}, "z is empty."),
    ({"x": "1/u"}, "x is not finite at u = 0, v = 0."),
    ({"minu": 1, "maxu": 0}, f"The range of U is empty: minu must be below maxu{DIGITS}"),
    ({"maxv": np.inf}, FINITE.format("v")),
    (
        {"x": "1", "y": "2", "z": "3"},
        "All points lie in one place: there is no surface to reconstruct.",
    ),
    (
        {"x": "u", "y": "v", "z": "0", "topology": 0},
        "All points lie on a plane: a closed surface cannot be fitted to them. Use topology=1, "
        "which makes a sheet of them.",
    ),
    (
        {"x": "cos(u)", "y": "sin(u)", "z": "u"},
        "The surface has no area that could be measured.",
    ),
    (
        {"snapshots": "2"},
        "snapshots names 2 vertices, fewer than the 4 vertices of the starting mesh.",
    ),
]


@pytest.mark.parametrize(("parameters", "sentence"), IMPLICIT_CASES)
def test_what_is_no_implicit_surface_is_refused(
    parameters: dict[str, object], sentence: str, mesh_set: pymeshlab.MeshSet
) -> None:
    assert_refused(mesh_set, sentence, IMPLICIT, **({"targetvertnum": 100} | parameters))


@pytest.mark.parametrize(("parameters", "sentence"), PARAMETRIC_CASES)
def test_what_is_no_parametric_surface_is_refused(
    parameters: dict[str, object], sentence: str, mesh_set: pymeshlab.MeshSet
) -> None:
    assert_refused(mesh_set, sentence, PARAMETRIC, **({"targetvertnum": 100} | parameters))


def test_the_plugin_needs_no_muparser_of_the_host(plugin: Path) -> None:
    needed = subprocess.run(
        ["readelf", "--dynamic", str(plugin)], capture_output=True, text=True, check=True
    ).stdout
    assert "NEEDED" in needed
    assert "muparser" not in needed
