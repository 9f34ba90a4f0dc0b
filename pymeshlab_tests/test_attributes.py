# SPDX-License-Identifier: GPL-3.0-or-later
"""TransferAttributes: colour and quality of the input on the result."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from documents import reconstruct, sphere_points


def coloured_sphere() -> pymeshlab.MeshSet:
    """Return a document of 20,000 points, red where x > 0 and blue elsewhere, quality z."""
    points = sphere_points(20_000)
    colours = np.where(points[:, :1] > 0, [[1.0, 0, 0, 1]], [[0, 0, 1.0, 1]])
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(
        pymeshlab.Mesh(points, v_color_matrix=colours, v_scalar_array=points[:, 2].copy()),
        "cloud",
    )
    return document


def test_colour_and_quality_are_those_of_the_points_around(plugin: Path) -> None:
    document = coloured_sphere()
    reconstruct(document, targetvertnum=1000)
    mesh = document.current_mesh()
    assert mesh.has_vertex_color()
    assert mesh.has_vertex_scalar()
    points, colours = mesh.vertex_matrix(), mesh.vertex_color_matrix()
    # An edge is about 0.12 long: further from the border than that, there is one colour only.
    red, blue = points[:, 0] > 0.15, points[:, 0] < -0.15
    np.testing.assert_array_equal(colours[red], np.tile([1.0, 0, 0, 1], (red.sum(), 1)))
    np.testing.assert_array_equal(colours[blue], np.tile([0, 0, 1.0, 1], (blue.sum(), 1)))
    # The mean over a cell differs from the value in its middle by its points' scatter: 20 points
    # of deviation 0.03.
    assert np.sqrt(np.mean((mesh.vertex_scalar_array() - points[:, 2]) ** 2)) < 0.015


def test_off_leaves_the_result_without(plugin: Path) -> None:
    document = coloured_sphere()
    reconstruct(document, targetvertnum=300, transferattributes=False)
    # MeshLab keeps room for a colour and a quality in every layer: they are as in a new one.
    mesh = document.current_mesh()
    assert len(np.unique(mesh.vertex_color_matrix(), axis=0)) == 1
    assert not mesh.vertex_scalar_array().any()


def test_surface_gives_what_lies_between_its_vertices(plugin: Path) -> None:
    document = pymeshlab.MeshSet(verbose=False)
    document.create_sphere(subdiv=1)
    mesh = document.current_mesh()
    points, faces = mesh.vertex_matrix().copy(), mesh.face_matrix().copy()
    document.clear()
    document.add_mesh(pymeshlab.Mesh(points, faces, v_scalar_array=points[:, 2].copy()), "ball")
    reconstruct(document, targetvertnum=1000, source=1)
    mesh = document.current_mesh()
    # 42 vertices to 1,000: the values of the nearest of them would be off by half an edge, 0.15
    # in the mean square, those on the faces only by the scatter within a cell.
    assert np.sqrt(np.mean((mesh.vertex_scalar_array() - mesh.vertex_matrix()[:, 2]) ** 2)) < 0.03


def test_colours_of_a_file_without_quality(plugin: Path, sample_meshes: Path) -> None:
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(sample_meshes / "chameleon.pts"))
    assert document.current_mesh().has_vertex_color()
    mean = document.current_mesh().vertex_color_matrix()[:, :3].mean(axis=0)
    reconstruct(document, targetvertnum=1000)
    mesh = document.current_mesh()
    assert mesh.has_vertex_color()
    # Uneven sampling weighs colours differently, but the picture stays the same.
    assert mesh.vertex_color_matrix()[:, :3].mean(axis=0) == pytest.approx(mean, abs=0.1)


def test_snapshots_have_them_too(plugin: Path) -> None:
    document = coloured_sphere()
    reconstruct(document, targetvertnum=500, snapshots="100")
    assert all(mesh.has_vertex_color() for mesh in document)
