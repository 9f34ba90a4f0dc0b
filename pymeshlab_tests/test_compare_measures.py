# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/compare.py: its measures on shapes of known answers, its rule on made-up figures."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from neuralmesh_tools.comparison.clouds import Cloud, Reference, load_cloud, load_surface
from neuralmesh_tools.comparison.figures import error_ticks
from neuralmesh_tools.comparison.kept import keep, kept
from neuralmesh_tools.comparison.measures import error_of, measure
from neuralmesh_tools.comparison.run import (
    Comparison,
    Result,
    default_vertices,
    in_per_cent,
)
from neuralmesh_tools.comparison.verdict import judge
from neuralmesh_tools.generated_clouds import write_ply
from neuralmesh_tools.layers import why_no_points
from neuralmesh_tools.methods import Reconstruction
from neuralmesh_tools.quality.shapes import unit_sphere

SPHERE = unit_sphere(40)


def sphere_cloud() -> Cloud:
    """The 6,402 vertices of SPHERE, with their true normals."""
    points, _ = SPHERE
    return Cloud(points, points, "its own", spacing=0.03)


@pytest.mark.parametrize(
    ("errors", "ticks"),
    [
        ([0.21, 0.45], [0.2, 0.5]),  # where Plotly has no tick of its own
        ([0.5, 2.0], [0.5, 1, 2]),
        ([0.04], [0.02, 0.05]),
        ([0.001], [0.001, 0.002]),
        ([0.0, 0.3], [0.2, 0.5]),
        ([], [1, 2]),
        ([3e-9, 0.02], [10.0**k for k in range(-9, 0)]),
    ],
)
def test_ticks_of_errors_enclose_them(errors: list[float], ticks: list[float]):
    assert error_ticks(errors) == pytest.approx(ticks)


def test_a_larger_sphere_is_off_by_its_radius_against_a_surface_and_a_cloud():
    points, faces = SPHERE
    for surface in (SPHERE, None):
        measured = measure(1.01 * points, faces, sphere_cloud(), surface, threshold=0.005)
        values = measured.values
        # Faces lie up to 1 - cos(half an edge's angle), 4e-4, inside their sphere.
        for name in ("rms", "rms_to_mesh", "rms_to_reference", "chamfer"):
            assert values[name] == pytest.approx(0.01, rel=0.05), name
        for name in ("hausdorff_to_mesh", "hausdorff_to_reference"):
            assert values[name] == pytest.approx(0.01, rel=0.1), name
        assert measured.face_error == pytest.approx(np.full(len(faces), 0.01), rel=0.1)
        assert values["f_score"] == 0
        assert error_of(1.01 * points, faces, sphere_cloud(), surface) == values["rms"]
        wide = measure(1.01 * points, faces, sphere_cloud(), surface, threshold=0.02)
        assert wide.values["f_score"] == pytest.approx(100)
        # Nearest normals of points a tenth of an edge apart differ by a degree or two.
        assert 99.5 < values["normal_consistency"] <= 100
        assert values["far_from_points"] == values["missed"] == 0
        assert (values["genus"], values["boundary_edges"], values["components"]) == (0, 0, 1)
        assert values["valence_6"] > 99
        assert measured.valence_shares[6] == values["valence_6"]
        assert sum(measured.valence_shares) == pytest.approx(100)


def test_gaps_between_points_are_no_error_but_surface_far_from_them_is():
    # Points 1 apart on a plane: a spot between them is on it, one 10 outside is 10 away.
    x, y = np.meshgrid(np.arange(20.0), np.arange(20.0))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(400)])
    cloud = Cloud(points, np.tile([0.0, 0, 1], (400, 1)), "its own", spacing=1.0)
    reference = Reference(cloud, None)
    probes = np.array([[4.5, 4.5, 0.0], [4.5, 4.5, 0.2], [29.0, 5.0, 0.0]])
    assert reference.distances(probes) == pytest.approx([0, 0.2, 10])
    assert reference.far_from_points(probes).tolist() == [False, False, True]


def test_what_a_mesh_leaves_out_is_missed():
    points, faces = unit_sphere(12)
    half = faces[points[faces][:, :, 2].max(axis=1) <= 0]
    values = measure(points, half, sphere_cloud(), None, threshold=0.005).values
    # The upper half but for three spacings of its border.
    assert 40 < values["missed"] < 50
    assert values["far_from_points"] == 0


def test_normals_are_the_clouds_own_or_estimated_and_said_to_be(tmp_path: Path):
    points, _ = unit_sphere(12)
    write_ply(tmp_path / "bare.ply", points)
    bare = load_cloud(str(tmp_path / "bare.ply"))
    assert bare.normals_from == "estimated from 16 neighbours, as it has none"
    # The 16 nearest of 578 points on a sphere span 25 degrees or so: the plane tilts by less.
    assert np.min(np.sum(bare.normals * points, axis=1)) > 0.99
    rows = np.hstack([points, -2 * points])
    np.savetxt(tmp_path / "own.xyz", rows)
    own = load_cloud(str(tmp_path / "own.xyz"))
    assert own.normals_from == "its own"
    assert own.normals == pytest.approx(-points, abs=1e-6)


def test_repeated_points_count_once_and_the_spacing_is_that_of_neighbours(tmp_path: Path):
    grid = np.column_stack([np.arange(30.0), np.zeros(30), np.arange(30) % 2])
    write_ply(tmp_path / "line.ply", np.vstack([grid, grid]))
    cloud = load_cloud(str(tmp_path / "line.ply"))
    assert len(cloud.points) == 30
    assert cloud.spacing == pytest.approx(np.sqrt(2))


def test_a_cloud_or_reference_that_cannot_be_used_is_a_sentence(tmp_path: Path):
    write_ply(tmp_path / "few.ply", np.eye(3))
    with pytest.raises(ValueError, match="It holds 3 points; 17 are the least"):
        load_cloud(str(tmp_path / "few.ply"))
    with pytest.raises(ValueError, match="It has no faces"):
        load_surface(str(tmp_path / "few.ply"))


def test_vertices_are_5000_by_default_but_a_quarter_of_the_points_at_most():
    assert default_vertices(1_000_000) == 5000
    assert default_vertices(2000) == 500


def result(method: str, rms: float, seconds: float, **changes: float) -> Result:
    """A made-up result: closed, sound and on the data unless changed."""
    sound = {
        "faces": 1000,
        "self_intersecting": 0,
        "non_manifold_edges": 0,
        "boundary_edges": 0,
        "far_from_points": 0.0,
    }
    values = {**sound, "rms_percent": rms, "seconds": seconds, **changes}
    nothing = Reconstruction(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32), seconds)
    return Result(method, values=values, mesh=nothing)


def verdict_on(*results: Result) -> tuple[str, str]:
    """The method recommended and all that is said."""
    verdict = judge(Comparison("made-up", "", "", sphere_cloud().facts(), 500, list(results)))
    return verdict.method, f"{verdict.sentence} {verdict.more}"


def test_of_closed_meshes_the_most_accurate_is_recommended():
    method, words = verdict_on(result("poisson", 0.01, 5), result("neural-mesh", 0.02, 1))
    assert method == "poisson"
    assert "the least error of the closed, sound meshes; Neural Mesh has 2 times as much" in words
    assert "If time matters, Neural Mesh is 5 times as fast" in words


def test_of_errors_within_a_tenth_the_fastest_is_recommended():
    method, words = verdict_on(result("poisson", 0.0100, 5), result("neural-mesh", 0.0105, 1))
    assert method == "neural-mesh"
    assert "as accurate as screened Poisson and 5 times as fast" in words


def test_no_error_at_all_is_no_trouble():
    method, words = verdict_on(result("poisson", 0.0, 5), result("neural-mesh", 0.02, 1))
    assert method == "poisson"
    assert "without error, alone of the closed, sound meshes" in words
    assert verdict_on(result("poisson", 0.0, 5), result("vcg", 0.0, 1))[0] == "vcg"


@pytest.mark.parametrize(
    "flaw", [{"boundary_edges": 3}, {"non_manifold_edges": 1}, {"self_intersecting": 6}]
)
def test_a_flawed_mesh_is_not_recommended_where_a_closed_sound_one_is(flaw: dict[str, float]):
    flawed = result("ball-pivoting", 0.001, 0.1, **flaw)
    method, words = verdict_on(flawed, result("neural-mesh", 0.02, 1))
    assert method == "neural-mesh"
    assert "there are no other closed, sound meshes" in words


def test_an_open_scan_takes_an_open_mesh_and_names_the_one_that_closes_it():
    method, words = verdict_on(
        result("poisson", 0.5, 5, far_from_points=40.0),
        result("neural-mesh", 0.2, 1, far_from_points=30.0),
        result("ball-pivoting", 0.01, 0.1, boundary_edges=300, non_manifold_edges=1),
        result("alpha-shape", 0.001, 0.1, boundary_edges=300, non_manifold_edges=400),
    )
    assert method == "ball-pivoting"
    assert words.startswith("The scan is open: use ball pivoting, RMS error")
    assert "If it must be closed, use Neural Mesh" in words
    assert "30 % of its surface is made up" in words


def test_a_time_out_is_named_as_the_reason():
    late = Result("poisson", "It timed out: it was not done in time.", "timed out")
    assert verdict_on(late) == (
        "",
        "No method gave a mesh. Screened Poisson timed out: a longer --timeout may change the "
        "answer.",
    )
    late = [late, replace(late, method="vcg")]
    method, words = verdict_on(*late, result("neural-mesh", 0.1, 1))
    assert method == "neural-mesh"
    assert "Screened Poisson and the VCG volume timed out: a longer --timeout may" in words


def test_an_answer_that_is_doubted_says_so():
    doubted = replace(result("neural-mesh", 0.1, 1), doubts="The points leave the shape open.")
    _, words = verdict_on(doubted)
    assert words.endswith("Look at it before you trust it: The points leave the shape open.")


def test_errors_are_told_in_per_cent_and_named_for_it():
    values = in_per_cent({"rms": 0.02, "missed": 3.0, "genus": None}, 50)
    assert values == {"rms_percent": 1.0, "missed": 3.0, "genus": None}


def made_up() -> Comparison:
    """A comparison with a mesh, a failure and a figure that is none."""
    points, faces = SPHERE
    mesh = Reconstruction(points, faces, 1.5, 1.25, {"genus": 0})
    values = {"genus": None, "rms_percent": 0.5, "faces": len(faces)}
    error = np.linspace(0, 1, len(faces), dtype="f4")
    shares = [0.0, 100.0]
    full = Result("neural-mesh", "", "returned", "Doubt.", values, [(9, 0.5)], mesh, error, shares)
    failed = Result("poisson", "It timed out.", "timed out")
    return Comparison("sphere", "a.ply", "", sphere_cloud().facts(), 500, [full, failed])


def test_what_is_kept_comes_back_as_it_was(tmp_path: Path):
    comparison = made_up()
    keep(comparison, tmp_path, "0" * 64)
    again = kept("sphere", "a.ply", tmp_path, "0" * 64)
    assert again is not None
    assert again.cloud is not None
    assert comparison.cloud is not None
    np.testing.assert_array_equal(again.cloud.shown, comparison.cloud.shown)
    assert replace(again.cloud, shown=comparison.cloud.shown) == comparison.cloud
    assert (again.vertices, again.results[1]) == (500, comparison.results[1])
    first, before = again.results[0], comparison.results[0]
    assert first.mesh is not None
    assert before.mesh is not None
    np.testing.assert_array_equal(first.mesh.faces, before.mesh.faces)
    np.testing.assert_array_equal(first.face_error, before.face_error)
    same = {"mesh": None, "face_error": None}
    assert replace(first, **same) == replace(before, **same)
    assert kept("sphere", "a.ply", tmp_path, "1" * 64) is None


def test_what_may_go_well_another_time_is_not_kept(tmp_path: Path):
    comparison = made_up()
    crashed = Result("poisson", "The process crashed with SIGSEGV.", "crashed")
    keep(replace(comparison, results=[crashed]), tmp_path, "0" * 64)
    keep(replace(comparison, cloud=None), tmp_path, "1" * 64)
    assert not (tmp_path / ".compare").exists()


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04", b"\x80\x04N.", b"text"])
def test_what_is_kept_in_a_foreign_folder_runs_nothing(tmp_path: Path, content: bytes):
    keep(made_up(), tmp_path, "0" * 64)
    file = tmp_path / ".compare" / f"{'0' * 64}.npz"
    file.write_bytes(content)
    assert kept("sphere", "a.ply", tmp_path, "0" * 64) is None
    pickled = io.BytesIO()
    np.savez(pickled, told=np.array([object()], dtype=object))
    file.write_bytes(pickled.getvalue())
    assert kept("sphere", "a.ply", tmp_path, "0" * 64) is None


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "It holds no points."),
        ("a.xyz", " \n\n", "It holds no points."),
        ("a.xyz", "# x y z\n", "It holds no points."),
        ("a.xyz", "x;y;z\n1;2;3\n", "No points of it can be read: its first line is 'x;y;z'."),
        ("a.stl", "\0" * 80, "No points of it can be read, though it is not empty: is it a .stl"),
    ],
)
def test_a_file_holds_no_points_only_where_that_is_so(
    tmp_path: Path, name: str, content: str, sentence: str
):
    (tmp_path / name).write_text(content, encoding="utf-8")
    assert why_no_points(tmp_path / name).startswith(sentence)


def test_failures_alone_recommend_nothing():
    failed = Result("poisson", "The process crashed with SIGSEGV.")
    assert verdict_on(failed)[0] == ""
    assert verdict_on(failed, result("neural-mesh", 0.1, 1))[0] == "neural-mesh"
