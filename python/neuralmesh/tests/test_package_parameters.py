# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters: spellings, suggestions, and sentences with the names that the caller typed."""

from __future__ import annotations

import neuralmesh
import numpy as np
import pytest
from neuralmesh._parameters import NAMES, key_of
from numpy.typing import NDArray

Points = NDArray[np.float64]


@pytest.mark.parametrize("name", NAMES)
def test_every_name_may_be_spelled_as_in_pymeshlab_or_the_dialog(name: str) -> None:
    assert key_of(name) == name
    assert key_of(name.replace("_", "")) == name
    assert key_of(name.title().replace("_", "")) == name


@pytest.mark.parametrize("name", ["vertices", "target_vert_num", "targetvertnum"])
def test_the_target_has_three_names(name: str, ball: Points) -> None:
    assert len(neuralmesh.reconstruct(ball, **{name: 60}).vertices) == 60


@pytest.mark.parametrize(
    ("typed", "suggestion"),
    [
        ("winer_rate", "winner_rate"),
        ("winerrate", "winnerrate"),
        ("targetvertnumber", "targetvertnum"),
        ("target_vert", "target_vert_num"),
        ("max_hole_sise", "max_hole_size"),
        ("boundary", "boundaries"),
        ("seed", "random_seed"),
    ],
)
def test_an_unknown_name_suggests_the_nearest(typed: str, suggestion: str, ball: Points) -> None:
    with pytest.raises(TypeError, match=rf"no parameter '{typed}'\. Did you mean '{suggestion}'"):
        neuralmesh.reconstruct(ball, 60, **{typed: 1})


@pytest.mark.parametrize("name", ["source", "pointfile", "startlayer", "expr"])
def test_what_is_said_otherwise_here_says_how(name: str, ball: Points) -> None:
    with pytest.raises(TypeError, match=r"There is no parameter .* here: .*(give|first argument)"):
        neuralmesh.reconstruct(ball, 60, **{name: 1})


def test_a_parameter_given_twice_is_refused(ball: Points) -> None:
    with pytest.raises(TypeError, match="vertices and targetvertnum are the same parameter"):
        neuralmesh.reconstruct(ball, 60, targetvertnum=60)


@pytest.mark.parametrize(
    ("parameters", "sentence"),
    [
        ({"targetvertnum": 3}, "targetvertnum must be at least 4, not 3."),
        ({"vertices": 6000}, "vertices is 6000, but there are only 5000 distinct points"),
        ({"WinnerRate": 1}, "WinnerRate must lie between 0 and 1, both excluded."),
        ({"counter_decay": float("nan")}, "counter_decay must lie between 0 and 1"),
        ({"signalspersplit": 0}, "signalspersplit must be at least 1, not 0."),
        ({"max_hole_size": -1}, "max_hole_size must be at least 0, not -1."),
        ({"max_hole_size": "wide"}, "must be a length or a percentage, not 'wide'"),
        ({"topology": 2}, "topology must be one of 0 'start', 1 'learned', not 2."),
        ({"split_rule": "even"}, "split_rule must be one of 0 'balanced', 1 'paper', not 'even'"),
        ({"start_mesh": 3}, r"Give the mesh itself: start_mesh=\(vertices, faces\)."),
        ({"random_seed": -1}, r"random_seed must be 0 \(a fresh seed\) or positive, not -1."),
        ({"vertices": 9, "snapshots": "12,x"}, "snapshots must be vertex counts"),
        (
            {"targetvertnum": 500, "snapshots": [600]},
            "snapshots names 600 vertices, more than targetvertnum, which is 500.",
        ),
        ({"vertices": 2**40}, "vertices is 1099511627776, but 2147483647 is the most"),
    ],
)
def test_a_value_out_of_range_is_refused_in_the_callers_words(
    parameters: dict[str, object], sentence: str, ball: Points
) -> None:
    with pytest.raises(neuralmesh.InvalidInput, match=sentence):
        neuralmesh.reconstruct(ball, **parameters)


@pytest.mark.parametrize(
    ("parameters", "sentence"),
    [
        ({"vertices": 60.5}, "vertices must be a whole number, not 60.5."),
        ({"vertices": True}, "vertices must be a whole number, not True."),
        ({"winner_rate": "fast"}, "winner_rate must be a number, not 'fast'."),
        ({"edge_flips": "no"}, "edge_flips must be True or False, not 'no'."),
        ({"start_mesh": [1, 2, 3]}, r"start_mesh must be a name, a number or \(vertices, faces\)"),
    ],
)
def test_a_value_of_another_type_is_refused(
    parameters: dict[str, object], sentence: str, ball: Points
) -> None:
    with pytest.raises(TypeError, match=sentence):
        neuralmesh.reconstruct(ball, **parameters)


def test_numbers_of_any_kind_are_taken(ball: Points) -> None:
    expected = neuralmesh.reconstruct(ball, 60, random_seed=7)
    for vertices, seed in ((60.0, np.int64(7)), (np.uint16(60), 7.0), ("60", "7")):
        made = neuralmesh.reconstruct(ball, vertices, random_seed=seed)
        assert np.array_equal(made.vertices, expected.vertices)


def test_choices_are_numbers_as_in_the_filter_or_names(ball: Points) -> None:
    by_number = neuralmesh.reconstruct(ball, 60, topology=0, start_mesh=2, split_rule=1)
    by_name = neuralmesh.reconstruct(
        ball, 60, topology="start", start_mesh="icosahedron", split_rule="paper"
    )
    assert np.array_equal(by_number.vertices, by_name.vertices)


def test_a_hole_size_is_a_length_or_a_share_of_the_diagonal(ball: Points) -> None:
    half = ball[ball[:, 2] > 0]
    diagonal = float(np.linalg.norm(half.max(axis=0) - half.min(axis=0)))
    by_share = neuralmesh.reconstruct(half, 200, boundaries=1, max_hole_size="20 %")
    by_length = neuralmesh.reconstruct(half, 200, boundaries=1, max_hole_size=0.2 * diagonal)
    assert np.array_equal(by_share.vertices, by_length.vertices)
    assert by_share.info["boundary_loops"] == 1


def test_seed_0_is_a_fresh_one_and_told(ball: Points) -> None:
    first, second = (neuralmesh.reconstruct(ball, 60, random_seed=0) for _ in range(2))
    assert first.info["seed"] != second.info["seed"]
    again = neuralmesh.reconstruct(ball, 60, random_seed=first.info["seed"])
    assert np.array_equal(again.vertices, first.vertices)


def test_snapshots_come_by_count(ball: Points) -> None:
    made = neuralmesh.reconstruct(ball, 300, snapshots=[200, 100])
    assert [len(mesh.vertices) for mesh in made.snapshots] == [100, 200]
    as_text = neuralmesh.reconstruct(ball, 300, snapshots="100, 200")
    assert np.array_equal(as_text.snapshots[1].vertices, made.snapshots[1].vertices)


def test_growth_starts_from_a_mesh_that_is_given(ball: Points) -> None:
    start = neuralmesh.reconstruct(ball, 50)
    made = neuralmesh.reconstruct(ball, 200, start_mesh=start)
    pair = neuralmesh.reconstruct(ball, 200, startmesh=(start.vertices, start.faces))
    assert np.array_equal(made.vertices, pair.vertices)
    with pytest.raises(neuralmesh.InvalidInput, match="The starting mesh is not closed: 3 edges"):
        neuralmesh.reconstruct(ball, 200, start_mesh=(start.vertices, start.faces[1:]))


def test_a_plane_says_which_parameter_helps() -> None:
    plane = np.random.default_rng(0).random((400, 3)) * [1, 1, 0]
    with pytest.raises(neuralmesh.InvalidInput, match=r"Use topology=1, which makes a sheet"):
        neuralmesh.reconstruct(plane, 50, topology=0)


def test_the_summary_names_what_the_caller_typed(ball: Points) -> None:
    made = neuralmesh.reconstruct(ball[ball[:, 2] > 0], targetvertnum=150, topology=0)
    assert "Try topology=1" in made.summary
    assert made.summary.startswith("Neural mesh: 150 vertices")
