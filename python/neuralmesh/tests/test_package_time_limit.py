# SPDX-License-Identifier: GPL-3.0-or-later
"""`time_limit`, and `--time-limit` of the command: the mesh so far."""

from __future__ import annotations

import json
import time
from pathlib import Path

import neuralmesh
import numpy as np
import pytest
from neuralmesh.command import main
from numpy.typing import NDArray

Points = NDArray[np.float64]


def ball_of(count: int) -> Points:
    points = np.random.default_rng(0).normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]


def assert_closed(mesh: neuralmesh.Mesh) -> None:
    edges = {
        (int(a), int(b))
        for face in mesh.faces
        for a, b in zip(face, np.roll(face, -1), strict=True)
    }
    assert len(edges) == 3 * len(mesh.faces)
    assert {(b, a) for a, b in edges} == edges


def test_a_limit_that_passes_at_once_leaves_the_tetrahedron(ball: Points) -> None:
    colours = np.full((len(ball), 3), 9, np.uint8)
    result = neuralmesh.reconstruct(ball, 2000, colours=colours, time_limit=1e-9)
    assert len(result.vertices) == 4
    assert_closed(result)
    assert result.info["reached_target"] is False
    assert "time_limit ended the growth: this is the mesh so far." in result.summary
    assert result.colours is not None
    assert (result.colours[:, :3] == 9).all()


def test_the_mesh_so_far_has_what_time_was_for() -> None:
    points = ball_of(1_000_000)
    begin = time.process_time()
    # CPU time, which a busy machine does not stretch, and four times what is promised.
    result = neuralmesh.reconstruct(points, 100_000, time_limit=2, threads=1)
    assert time.process_time() - begin < 4
    assert result.info["reached_target"] is False
    assert len(result.vertices) < 100_000
    assert_closed(result)


def test_points_on_a_plane_and_few_points_are_no_error() -> None:
    """Of the points that were read in time, nothing is known."""
    plane = np.random.default_rng(0).random((1000, 3)) * [1, 1, 0]
    for points in (plane, ball_of(10)):
        result = neuralmesh.reconstruct(points, 500, time_limit=1e-9)
        assert len(result.vertices) == 4


def test_a_file_is_read_as_far_as_there_is_time(tmp_path: Path) -> None:
    lines = "\n".join(f"{x} {y} {z}" for x, y, z in ball_of(300_000))
    (tmp_path / "ball.xyz").write_text(lines, "utf-8")
    result = neuralmesh.reconstruct(tmp_path / "ball.xyz", 1000, time_limit=1e-9)
    assert len(result.vertices) == 4
    whole = neuralmesh.read(tmp_path / "ball.xyz")
    part = neuralmesh.files.read(tmp_path / "ball.xyz", is_time_up=lambda: True)
    assert 0 < len(part.points) < len(whole.points) == 300_000
    assert np.array_equal(part.points, whole.points[: len(part.points)])


@pytest.mark.parametrize("seconds", [-1, float("nan"), -1e-9])
def test_what_is_no_length_of_time_is_refused(ball: Points, seconds: float) -> None:
    with pytest.raises(neuralmesh.InvalidInput, match="time_limit must be at least 0, not"):
        neuralmesh.reconstruct(ball, 100, time_limit=seconds)
    with pytest.raises(TypeError, match="timelimit must be a number, not 'soon'"):
        neuralmesh.reconstruct(ball, 100, timelimit="soon")


def test_the_command_has_it(
    ball: Points, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cloud, out = tmp_path / "ball.npy", tmp_path / "ball.ply"
    np.save(cloud, ball)
    given = [str(cloud), "-n", "2000", "-o", str(out), "--json", "-q", "--time-limit"]
    assert main([*given, "1e-6"]) == 0
    assert json.loads(capsys.readouterr().out)["reached_target"] is False
    assert main([*given, "-1"]) == 1
    assert "--time-limit must be at least 0, not -1." in capsys.readouterr().err
