# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameter `timelimit` of all filters: the mesh so far."""

from __future__ import annotations

import time

import numpy as np
import pymeshlab
import pytest
from documents import FILTER, IMPLICIT, PARAMETRIC, Points, document_of, sphere_points
from test_log import Log, log

__all__ = ["log"]  # a fixture

pytestmark = pytest.mark.usefixtures("plugin")

# What a run goes on for after its limit, in CPU time, which a busy machine does not stretch, and
# four times what is promised, for machines that are slower. Without a limit it takes a minute.
SECONDS_AFTER = 2.0


def assert_closed(document: pymeshlab.MeshSet) -> None:
    measures = document.get_topological_measures()
    assert measures["is_mesh_two_manifold"]
    assert measures["boundary_edges"] == 0


@pytest.mark.parametrize("name", [FILTER, IMPLICIT, PARAMETRIC])
def test_a_limit_that_passes_at_once_leaves_the_tetrahedron(name: str) -> None:
    document = document_of(sphere_points(5000, 1))
    before = document.mesh_number()
    result = document.apply_filter(name, targetvertnum=2000, timelimit=1e-6)
    assert result["vertices"] == 4
    assert result["reached_target"] is False
    assert document.mesh_number() == before + 1
    assert_closed(document)


def test_a_run_of_many_vertices_ends_soon_after_its_limit() -> None:
    document = document_of(sphere_points(1_000_000, 1))
    begin = time.process_time()
    result = document.apply_filter(FILTER, targetvertnum=100_000, timelimit=1, threads=1)
    assert result["reached_target"] is False
    assert 4 <= result["vertices"] < 100_000
    assert time.process_time() - begin < 1 + SECONDS_AFTER
    assert_closed(document)


def test_a_limit_that_does_not_pass_changes_nothing() -> None:
    points = sphere_points(5000, 1)
    meshes = []
    for parameters in ({}, {"timelimit": 1000.0}):
        document = document_of(points)
        result = document.apply_filter(FILTER, targetvertnum=500, **parameters)
        assert result["reached_target"] is True
        meshes.append(document.current_mesh().vertex_matrix())
    assert np.array_equal(*meshes)


def test_a_negative_limit_is_refused() -> None:
    document = document_of(sphere_points(500, 1))
    for seconds in (-1.0, float("nan")):
        with pytest.raises(pymeshlab.PyMeshLabException, match="timelimit must be at least 0, not"):
            document.apply_filter(FILTER, timelimit=seconds)
    assert document.mesh_number() == 1


def test_the_log_says_so(log: Log) -> None:
    points: Points = sphere_points(200_000, 1)
    line = log.of(points, targetvertnum=50_000, timelimit=1)
    assert "timelimit" in line
    assert "ended the growth: this is the mesh so far." in line
    assert "mesh so far" not in log.of(points, targetvertnum=500)
