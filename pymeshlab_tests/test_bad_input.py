# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input gives a clear sentence and leaves the document as it was."""

from __future__ import annotations

import time

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

GOOD_POINTS = sphere_points(50)


def with_broken(points: Points, broken: dict[int, float]) -> Points:
    """Return a copy in which one coordinate of each point named takes the value given."""
    copy = points.copy()
    for index, value in broken.items():
        copy[index, index % 3] = value
    return copy


def on_a_line(count: int) -> Points:
    """Return points on an oblique line, shape (count, 3)."""
    return np.linspace(-1, 2, count)[:, None] * np.array([1.0, 0.7, -0.3]) + 5.0


def on_a_plane(count: int) -> Points:
    """Return points on an oblique plane, shape (count, 3)."""
    flat = np.random.default_rng(3).uniform(size=(count, 2))
    return flat @ np.array([[1.0, 0.2, 0.5], [-0.3, 0.9, 0.4]]) + 5.0


POINT_CASES = [
    pytest.param(
        with_broken(GOOD_POINTS, {7: np.nan, 30: np.nan}),
        "2 of 50 points have coordinates that are NaN or infinite (the first is point 7). "
        "Remove them and try again.",
        id="nan",
    ),
    pytest.param(
        with_broken(GOOD_POINTS, {49: np.inf, 11: -np.inf, 12: np.nan}),
        "3 of 50 points have coordinates that are NaN or infinite (the first is point 11). "
        "Remove them and try again.",
        id="infinite",
    ),
    pytest.param(
        GOOD_POINTS[:3],
        "Only 3 distinct points: a closed surface needs at least 4.",
        id="three points",
    ),
    pytest.param(
        np.repeat(GOOD_POINTS[:3], 20, axis=0),
        "Only 3 distinct points: a closed surface needs at least 4.",
        id="three places, sixty points",
    ),
    pytest.param(
        np.tile([3.0, -2.0, 1.0], (50, 1)),
        "All points lie in one place: there is no surface to reconstruct.",
        id="one place",
    ),
    pytest.param(
        GOOD_POINTS[:1],
        "All points lie in one place: there is no surface to reconstruct.",
        id="one point",
    ),
    pytest.param(
        on_a_line(50),
        "All points lie on a line: there is no surface to reconstruct.",
        id="line",
    ),
    pytest.param(
        on_a_plane(50),
        "All points lie on a plane, and are too few or too uneven for a sheet to be found in them.",
        id="plane",
    ),
    pytest.param(
        GOOD_POINTS * 1e300,
        "The points' coordinates are too large: their bounding box's diagonal is not finite.",
        id="too large",
    ),
]


@pytest.mark.parametrize(("points", "sentence"), POINT_CASES)
def test_points_without_a_surface_are_refused(points: Points, sentence: str) -> None:
    assert_refused(document_of(points), sentence, targetvertnum=10)


@pytest.mark.parametrize("source", [0, 1])
def test_an_empty_document_is_refused(source: int, mesh_set: pymeshlab.MeshSet) -> None:
    with pytest.raises(pymeshlab.PyMeshLabException, match="There is no current layer: open or"):
        reconstruct(mesh_set, source=source)
    assert mesh_set.mesh_number() == 0


def test_a_layer_without_vertices_is_refused() -> None:
    document = document_of(GOOD_POINTS)
    document.set_selection_all()
    document.meshing_remove_selected_vertices()
    assert document.current_mesh().vertex_number() == 0
    assert_refused(document, "The current layer has no vertices.")


@pytest.mark.parametrize("target", [3, 0, -1, -(2**31)])
def test_a_target_below_a_tetrahedron_is_refused(target: int) -> None:
    assert_refused(
        document_of(GOOD_POINTS),
        f"targetvertnum must be at least 4, not {target}.",
        targetvertnum=target,
    )


def test_the_least_target_gives_a_tetrahedron() -> None:
    vertices, faces = mesh_from(GOOD_POINTS, targetvertnum=4)
    assert vertices.shape == (4, 3)
    assert faces.shape == (4, 3)


def test_a_target_above_the_bunnys_points_is_refused_at_once(
    bunny_points: pymeshlab.MeshSet,
) -> None:
    start = time.perf_counter()
    assert_refused(
        bunny_points,
        "targetvertnum is 30000, but there are only 28088 distinct points to draw from: "
        "at most 28088 vertices are possible.",
        targetvertnum=30000,
    )
    # Growing to 28,088 vertices takes some 10 s, counting points milliseconds.
    assert time.perf_counter() - start < 3


def test_coinciding_points_count_once_for_the_largest_target() -> None:
    # A negative zero is the same place as a positive one.
    points = np.vstack([GOOD_POINTS, GOOD_POINTS[::-1], [[0.0, 0.0, 0.0]], [[-0.0, 0.0, -0.0]]])
    assert_refused(
        document_of(points),
        "targetvertnum is 52, but there are only 51 distinct points to draw from: "
        "at most 51 vertices are possible.",
        targetvertnum=52,
    )


@pytest.mark.parametrize("value", [0.0, 1.0, -0.5, 1.5, np.nan, np.inf])
@pytest.mark.parametrize("name", ["WinnerRate", "SmoothingRate", "CounterDecay"])
def test_a_rate_outside_0_to_1_is_refused(name: str, value: float) -> None:
    assert_refused(
        document_of(GOOD_POINTS),
        f"{name.lower()} must lie between 0 and 1, both excluded.",
        targetvertnum=10,
        **{name.lower(): value},
    )


@pytest.mark.parametrize("value", [0, -3])
@pytest.mark.parametrize("name", ["SmoothingPasses", "SignalsPerSplit", "InactivityFactor"])
def test_a_count_below_1_is_refused(name: str, value: int) -> None:
    assert_refused(
        document_of(GOOD_POINTS),
        f"{name.lower()} must be at least 1, not {value}.",
        targetvertnum=10,
        **{name.lower(): value},
    )


@pytest.mark.parametrize(("name", "most"), [("SmoothingPasses", 100), ("SignalsPerSplit", 10_000)])
def test_a_count_that_would_take_for_ever_is_refused(name: str, most: int) -> None:
    assert_refused(
        document_of(GOOD_POINTS),
        f"{name.lower()} must be at most {most}, not {most + 1}.",
        targetvertnum=10,
        **{name.lower(): most + 1},
    )


def test_a_negative_seed_is_refused() -> None:
    assert_refused(
        document_of(GOOD_POINTS),
        "randomseed must be 0 (a fresh seed) or positive, not -1.",
        targetvertnum=10,
        randomseed=-1,
    )


@pytest.mark.parametrize("value", [2, -1, "Halves"])
def test_an_unknown_split_rule_is_refused(value: object) -> None:
    # PyMeshLab itself stops here, before the filter is asked.
    document = document_of(GOOD_POINTS)
    before = state_of(document)
    with pytest.raises(pymeshlab.InvalidEnumException):
        reconstruct(document, targetvertnum=10, splitrule=value)
    assert state_of(document) == before


def test_the_filter_works_after_a_refusal() -> None:
    document = document_of(GOOD_POINTS)
    assert_refused(document, "targetvertnum must be at least 4, not 3.", targetvertnum=3)
    assert reconstruct(document, targetvertnum=20)["vertices"] == 20
