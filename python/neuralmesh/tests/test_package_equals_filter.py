# SPDX-License-Identifier: GPL-3.0-or-later
"""The same input and parameters give the mesh of PyMeshLab's filter, bit for bit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import neuralmesh
import numpy as np
import pymeshlab
import pytest
from numpy.typing import NDArray

from neuralmesh_tools.layers import load_plugin
from neuralmesh_tools.project import PLUGIN

Points = NDArray[np.float64]

RECONSTRUCTION = "generate_surface_reconstruction_neural_mesh"
IMPLICIT = "create_neural_mesh_from_implicit_surface"
PARAMETRIC = "create_neural_mesh_from_parametric_surface"


@pytest.fixture
def document() -> pymeshlab.MeshSet:
    load_plugin(PLUGIN)
    return pymeshlab.MeshSet(verbose=False)


def assert_equals_filter(
    made: neuralmesh.Result, document: pymeshlab.MeshSet, info: dict[str, Any]
) -> None:
    mesh = document.current_mesh()
    assert np.array_equal(made.vertices, mesh.vertex_matrix())
    assert np.array_equal(made.faces, mesh.face_matrix())
    assert set(made.info) == set(info)
    for key in set(info) - {"seconds"}:
        assert np.array_equal(made.info[key], info[key]), key


@pytest.mark.parametrize(
    "parameters",
    [
        {},
        {"boundaries": 1},
        {"targetvertnum": 2000, "randomseed": 7, "topology": 0, "edgeflips": False},
        {"targetvertnum": 1500, "splitrule": 1, "surfacefit": False, "winnerrate": 0.07},
    ],
    ids=str,
)
def test_the_bunny(parameters: dict[str, Any], document: pymeshlab.MeshSet, bunny: Points) -> None:
    # Not loaded from the file: after a filter was refused in the same process, as tests before this
    # one do, PyMeshLab may crash in load_new_mesh().
    document.add_mesh(pymeshlab.Mesh(bunny), "bunny")
    info = document.apply_filter(RECONSTRUCTION, **parameters)
    assert_equals_filter(neuralmesh.reconstruct(bunny, **parameters), document, info)


def test_a_sheet_with_snapshots_colours_and_quality(
    document: pymeshlab.MeshSet, ball: Points
) -> None:
    half = ball[ball[:, 2] > 0]
    colours = np.hstack([np.abs(half), np.ones((len(half), 1))])
    document.add_mesh(
        pymeshlab.Mesh(half, v_color_matrix=colours, v_scalar_array=half[:, 0].copy())
    )
    bytes_ = np.rint(255 * document.current_mesh().vertex_color_matrix()).astype(np.uint8)
    info = document.apply_filter(
        RECONSTRUCTION, targetvertnum=300, boundaries=1, snapshots="100,200"
    )
    made = neuralmesh.reconstruct(
        half, 300, boundaries=1, snapshots=[100, 200], colours=bytes_, quality=half[:, 0]
    )
    assert_equals_filter(made, document, info)
    shades = np.rint(255 * document.current_mesh().vertex_color_matrix()).astype(np.uint8)
    assert np.array_equal(made.colours, shades)
    assert np.array_equal(made.quality, document.current_mesh().vertex_scalar_array())
    for layer, snapshot in zip(list(document)[1:3], made.snapshots, strict=True):
        assert np.array_equal(layer.vertex_matrix(), snapshot.vertices)


def test_density_from_quality(document: pymeshlab.MeshSet, ball: Points) -> None:
    quality = 1 + ball[:, 2]
    document.add_mesh(pymeshlab.Mesh(ball, v_scalar_array=quality))
    info = document.apply_filter(RECONSTRUCTION, targetvertnum=300, densityfromquality=True)
    made = neuralmesh.reconstruct(ball, 300, quality=quality, density_from_quality=True)
    assert_equals_filter(made, document, info)


def test_a_surface(document: pymeshlab.MeshSet, ball: Points) -> None:
    mesh = neuralmesh.reconstruct(ball, 300)
    document.add_mesh(pymeshlab.Mesh(mesh.vertices, mesh.faces))
    info = document.apply_filter(RECONSTRUCTION, targetvertnum=500, source=1)
    surface = neuralmesh.Surface(mesh.vertices, mesh.faces)
    assert_equals_filter(neuralmesh.reconstruct(surface, 500), document, info)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_a_file_read_in_place(
    kind: type, document: pymeshlab.MeshSet, ball: Points, tmp_path: Path
) -> None:
    np.save(tmp_path / "ball.npy", ball.astype(kind))
    path = tmp_path / "ball.npy"
    info = document.apply_filter(RECONSTRUCTION, source=3, pointfile=str(path), targetvertnum=500)
    assert_equals_filter(neuralmesh.reconstruct(path, 500), document, info)


def test_expressions(document: pymeshlab.MeshSet) -> None:
    info = document.apply_filter(IMPLICIT, targetvertnum=300, expr="x*x+y*y+2*z*z-0.5")
    source = neuralmesh.ImplicitSurface("x*x+y*y+2*z*z-0.5")
    assert_equals_filter(neuralmesh.reconstruct(source, 300), document, info)
    info = document.apply_filter(PARAMETRIC, targetvertnum=300, maxu=3.0, maxv=2.5)
    sphere = ("cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)")
    source = neuralmesh.ParametricSurface(sphere, (0, 3), (0, 2.5))
    assert_equals_filter(neuralmesh.reconstruct(source, 300), document, info)
