# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in and out: types, strides, what is refused."""

from __future__ import annotations

from types import SimpleNamespace

import neuralmesh
import numpy as np
import pytest
from numpy.typing import NDArray

Points = NDArray[np.float64]


def packed_records(points: Points) -> Points:
    """The points as a field of records whose length is no multiple of 8."""
    records = np.zeros(len(points), [("class", "u1"), ("xyz", "f8", 3)])
    records["xyz"] = points
    return records["xyz"]


LAYOUTS = {
    "rows": np.ascontiguousarray,
    "columns": np.asfortranarray,
    "every second of more": lambda p: np.repeat(p, 2, axis=0)[::2],
    "turned twice": lambda p: p[::-1].copy()[::-1],
    "columns of more": lambda p: np.hstack([p, p])[:, :3],
    "a field of packed records": packed_records,
    "of the other byte order": lambda p: p.astype(p.dtype.newbyteorder()),
    "a list": lambda p: p.tolist(),
}


@pytest.fixture(scope="module")
def expected(ball: Points) -> neuralmesh.Result:
    return neuralmesh.reconstruct(ball, 200)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_any_layout_gives_the_same_mesh(
    layout: str, ball: Points, expected: neuralmesh.Result
) -> None:
    made = neuralmesh.reconstruct(LAYOUTS[layout](ball), 200)
    assert np.array_equal(made.vertices, expected.vertices)
    assert np.array_equal(made.faces, expected.faces)


def test_float32_is_taken_as_it_is(ball: Points) -> None:
    single = ball.astype(np.float32)
    from_single = neuralmesh.reconstruct(single, 200)
    from_double = neuralmesh.reconstruct(single.astype(np.float64), 200)
    assert np.array_equal(from_single.vertices, from_double.vertices)


def test_whole_numbers_are_points_too() -> None:
    grid = np.stack(np.meshgrid(*[np.arange(12)] * 3), axis=-1).reshape(-1, 3)
    shell = grid[(grid % 11 == 0).any(axis=1)]
    assert len(neuralmesh.reconstruct(shell, 100).vertices) == 100


def test_the_input_stays_as_it_is(ball: Points) -> None:
    points = ball.copy()
    neuralmesh.reconstruct(points, 50)
    assert np.array_equal(points, ball)


def test_the_result_is_not_copied_from_the_core(expected: neuralmesh.Result) -> None:
    assert expected.vertices.dtype == np.float64
    assert expected.faces.dtype == np.int32
    for array in (expected.vertices, expected.faces):
        assert not array.flags.owndata  # the C++ vector does
        assert array.flags.c_contiguous
        assert array.flags.writeable


def test_the_result_outlives_everything_else(ball: Points) -> None:
    vertices = neuralmesh.reconstruct(ball, 100).vertices
    assert np.isfinite(vertices).all()
    assert 0.9 < np.linalg.norm(vertices, axis=1).mean() < 1.1


@pytest.mark.parametrize(
    ("points", "sentence"),
    [
        (np.zeros((3, 100)), r"points must have the shape \(N, 3\), not \(3, 100\)\."),
        (np.zeros(9), r"points must have the shape \(N, 3\), not \(9,\)\."),
        (np.zeros((0, 3)), "There are no points to reconstruct a surface from."),
        (np.full((9, 3), np.nan), "9 of 9 points have coordinates"),
        (np.zeros((9, 3)), "All points lie in one place: there is no surface"),
    ],
)
def test_what_is_no_cloud_is_refused_as_a_value(points: Points, sentence: str) -> None:
    with pytest.raises(neuralmesh.InvalidInput, match=sentence) as caught:
        neuralmesh.reconstruct(points, 10)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize(
    ("points", "sentence"),
    [
        (np.array([["a", "b", "c"]]), "points must be numbers, not <U1"),
        (None, "points must be numbers, not NoneType"),
        (SimpleNamespace(vertices=[], faces=[]), r"give mesh\.vertices, or Surface\("),
    ],
)
def test_what_is_no_array_is_refused_as_a_type(points: object, sentence: str) -> None:
    with pytest.raises(TypeError, match=sentence):
        neuralmesh.reconstruct(points, 10)


def test_few_points_make_half_as_many_vertices(ball: Points) -> None:
    assert len(neuralmesh.reconstruct(ball[:600]).vertices) == 300


def test_colours_and_quality_are_averaged_onto_the_result(ball: Points) -> None:
    quality = ball[:, 2]
    colours = np.where(ball[:, :1] > 0, [255, 0, 0], [0, 0, 255])
    made = neuralmesh.reconstruct(ball, 300, colours=colours, quality=quality, snapshots=[100])
    assert made.colours is not None
    assert made.quality is not None
    assert made.colours.shape == (300, 4)
    east = made.vertices[:, 0] > 0.2
    assert (made.colours[east] == [255, 0, 0, 255]).all()
    # The mean of 16 or so points around a vertex.
    assert np.abs(made.quality - made.vertices[:, 2]).max() < 0.1
    assert made.snapshots[0].colours is not None
    shares = neuralmesh.reconstruct(ball, 300, colours=colours / 255.0)
    assert np.array_equal(shares.colours, made.colours)
    assert neuralmesh.reconstruct(ball, 300).colours is None


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"colours": np.zeros((3, 3))}, r"colours must have the shape \(5000, 3\)"),
        ({"quality": np.zeros(3)}, r"quality must be one number for each point"),
        ({"density_from_quality": True}, "density_from_quality: give a quality too"),
        (
            {"densityfromquality": True, "quality": np.full(5000, -1.0)},
            "densityfromquality: the quality of 5000 of 5000 vertices is negative",
        ),
    ],
)
def test_attributes_that_do_not_fit_are_refused(
    given: dict[str, object], sentence: str, ball: Points
) -> None:
    with pytest.raises(neuralmesh.InvalidInput, match=sentence):
        neuralmesh.reconstruct(ball, 100, **given)
