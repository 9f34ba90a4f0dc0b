# SPDX-License-Identifier: GPL-3.0-or-later
"""Snapshots: layers at given vertex counts from one run."""

from __future__ import annotations

import numpy as np
import pymeshlab
import pytest
from documents import (
    Points,
    assert_refused,
    document_of,
    mesh_from,
    reconstruct,
    sphere_points,
    state_of,
)

pytestmark = pytest.mark.usefixtures("plugin")


def test_snapshots_become_layers_in_order_of_their_counts(bunny_points: pymeshlab.MeshSet) -> None:
    before = state_of(bunny_points)
    reconstruct(bunny_points, targetvertnum=1000, snapshots="500, 20,100")
    assert state_of(bunny_points).layers[:1] == before.layers
    layers = list(bunny_points)[1:]
    assert [layer.label() for layer in layers] == [
        "bunny neural mesh 20",
        "bunny neural mesh 100",
        "bunny neural mesh 500",
        "bunny neural mesh",
    ]
    assert bunny_points.current_mesh().label() == "bunny neural mesh"
    for layer, count in zip(layers, (20, 100, 500, 1000), strict=True):
        assert layer.vertex_number() == count
        assert layer.face_number() == 2 * count - 4
        bunny_points.set_current_mesh(layer.id())
        assert bunny_points.get_topological_measures()["is_mesh_two_manifold"]
        assert bunny_points.get_geometric_measures()["mesh_volume"] > 0


@pytest.mark.parametrize("surfacefit", [True, False])
def test_snapshots_leave_the_result_as_it_is_without_them(
    bunny_array: Points, surfacefit: bool
) -> None:
    with_them, _ = mesh_from(
        bunny_array, targetvertnum=400, snapshots="50,200,400", surfacefit=surfacefit
    )
    without, _ = mesh_from(bunny_array, targetvertnum=400, surfacefit=surfacefit)
    np.testing.assert_array_equal(with_them, without)


def test_snapshots_are_as_accurate_as_meshes_of_their_own(bunny_array: Points) -> None:
    # In the mean: two runs to so few vertices differ by a third.
    ratios = []
    for seed in (1, 2, 3, 4):
        document = document_of(bunny_array)
        reconstruct(document, targetvertnum=2000, snapshots="500", randomseed=seed)
        document.set_current_mesh(0)
        result = reconstruct(document, targetvertnum=500, randomseed=seed)
        measured = document.get_hausdorff_distance(
            sampledmesh=0, targetmesh=1, samplevert=True, sampleface=False, samplenum=10**6
        )
        ratios.append(measured["RMS"] / result["rms_error"])
    assert np.exp(np.mean(np.log(ratios))) < 1.2


SNAPSHOT_CASES = [
    (
        "20,x",
        "snapshots must be vertex counts separated by commas, such as 20,100,1000: 'x' is none.",
    ),
    (
        "20.5",
        "snapshots must be vertex counts separated by commas, such as 20,100,1000: '20.5' is none.",
    ),
    (
        "20,,30",
        "snapshots must be vertex counts separated by commas, such as 20,100,1000: '' is none.",
    ),
    (
        "20,99999999999",
        "snapshots must be vertex counts separated by commas, such as 20,100,1000: "
        "'99999999999' is none.",
    ),
    ("30,20,30", "snapshots names 30 vertices twice."),
    ("20,41", "snapshots names 41 vertices, more than targetvertnum, which is 40."),
    ("3,20", "snapshots names 3 vertices, fewer than the 4 vertices of the starting mesh."),
    ("-5", "snapshots names -5 vertices, fewer than the 4 vertices of the starting mesh."),
]


@pytest.mark.parametrize(("snapshots", "sentence"), SNAPSHOT_CASES)
def test_impossible_snapshots_are_refused(snapshots: str, sentence: str) -> None:
    assert_refused(document_of(sphere_points(100)), sentence, targetvertnum=40, snapshots=snapshots)


def test_a_run_that_fails_leaves_no_snapshots(bunny_points: pymeshlab.MeshSet) -> None:
    assert_refused(
        bunny_points,
        "targetvertnum is 30000, but there are only 28088 distinct points to draw from: at most "
        "28088 vertices are possible.",
        targetvertnum=30000,
        snapshots="20,100",
    )
