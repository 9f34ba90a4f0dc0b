# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter run again, as a notebook does: its result is current, and the scan is meant."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from documents import assert_refused, document_of, reconstruct, sphere_points, torus_mesh

pytestmark = pytest.mark.usefixtures("plugin")

POINTS, SURFACE, VISIBLE = 0, 1, 2


def twice(
    document: pymeshlab.MeshSet, **parameters: object
) -> tuple[pymeshlab.Mesh, pymeshlab.Mesh]:
    """Run the filter, and again on the document as it then is; return both results."""
    reconstruct(document, **parameters)
    first = document.current_mesh()
    reconstruct(document, **parameters)
    return first, document.current_mesh()


def assert_same(first: pymeshlab.Mesh, second: pymeshlab.Mesh) -> None:
    assert first.id() != second.id()
    assert second.label() == first.label() + "(1)"  # PyMeshLab tells labels apart
    np.testing.assert_array_equal(first.vertex_matrix(), second.vertex_matrix())
    np.testing.assert_array_equal(first.face_matrix(), second.face_matrix())


@pytest.mark.parametrize("source", [POINTS, VISIBLE])
def test_a_second_run_works_on_the_points_again(source: int) -> None:
    document = document_of(sphere_points(1000))
    first, second = twice(document, targetvertnum=200, source=source)
    assert_same(first, second)
    assert document.mesh_number() == 3


def test_a_second_run_works_on_the_surface_again() -> None:
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(torus_mesh(), "torus")
    first, second = twice(document, targetvertnum=150, source=SURFACE)
    assert_same(first, second)


def test_a_run_after_snapshots_and_with_the_default_target_works_on_the_points_again() -> None:
    document = document_of(sphere_points(600))
    first, second = twice(document, snapshots="50")
    assert first.vertex_number() == second.vertex_number() == 300  # half of the scan's points


def test_the_surface_of_a_result_is_still_a_surface_to_sample() -> None:
    document = document_of(sphere_points(1000))
    reconstruct(document, targetvertnum=200)
    reconstruct(document, targetvertnum=100, source=SURFACE)
    assert document.current_mesh().label() == "cloud neural mesh neural mesh"
    assert document.current_mesh().vertex_number() == 100


def test_a_result_that_was_changed_is_a_cloud_of_its_own() -> None:
    document = document_of(sphere_points(1000))
    reconstruct(document, targetvertnum=200)
    document.compute_matrix_from_scaling_or_normalization(axisx=2.0, freeze=True)
    assert_refused(
        document,
        "targetvertnum is 201, but there are only 200 distinct points to draw from: at most 200 "
        "vertices are possible.",
        targetvertnum=201,
    )


def test_a_result_whose_scan_is_gone_is_all_there_is() -> None:
    document = document_of(sphere_points(1000))
    reconstruct(document, targetvertnum=200)
    result = document.current_mesh_id()
    document.set_current_mesh(0)
    document.delete_current_mesh()
    document.set_current_mesh(result)
    reconstruct(document, targetvertnum=50)
    assert document.current_mesh().label() == "cloud neural mesh neural mesh"


def test_a_point_file_that_would_not_be_read_is_refused() -> None:
    assert_refused(
        document_of(sphere_points(100)),
        "pointfile names a file that would not be read: choose source=3, or leave pointfile empty.",
        pointfile="scan.las",
    )
