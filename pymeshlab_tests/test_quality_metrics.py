# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality table's metrics, on shapes whose answers are known."""

from __future__ import annotations

import dataclasses
import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab
import pytest

from neuralmesh_tools import geometry, layers, methods, metrics
from neuralmesh_tools.quality import bounds, inputs, models, report, shapes
from neuralmesh_tools.quality.row import Job, measure_row
from neuralmesh_tools.quality.run import Group, Row, Settings, Variant, run_group

CUBE_CORNERS = np.array(list(itertools.product([0.0, 1.0], repeat=3)))


def cube():
    """A unit cube of 12 faces."""
    return shapes.union_of_cells([0, 1], [0, 1], [0, 1], np.ones((1, 1, 1), dtype=bool))


def test_a_mesh_is_at_distance_zero_from_itself():
    found = metrics.distances(*cube(), *cube())
    # The filter answers in single precision.
    assert max(found.values()) < 1e-4


def test_concentric_spheres_are_the_difference_of_their_radii_apart():
    points, faces = shapes.unit_sphere(60)
    found = metrics.distances(1.01 * points, faces, points, faces)
    expected = 0.01 * 100 / geometry.diagonal(points)
    # The faces lie up to 1 - cos(half an edge's angle), 1e-4 of the radius, inside the sphere.
    for name in ("rms_to_mesh", "rms_to_surface", "max_to_mesh", "max_to_surface"):
        assert found[name] == pytest.approx(expected, rel=0.02), name


def test_a_bump_on_the_result_is_seen_from_its_side_only():
    points, faces = shapes.unit_sphere(20)
    bumped = points.copy()
    bumped[np.argmax(points[:, 2])] *= 1.5
    found = metrics.distances(bumped, faces, points, faces)
    assert found["max_to_surface"] == pytest.approx(0.5 * 100 / geometry.diagonal(points), rel=1e-6)
    assert found["max_to_mesh"] < 0.2 * found["max_to_surface"]


def test_distances_are_exact_to_faces_edges_and_corners_and_not_cut_off_far_away():
    probes = np.array([[0.3, 0.4, 1.7], [-1.0, -1.0, 0.5], [2.0, 2.0, 2.0], [90.0, 0.5, 0.5]])
    expected = [0.7, np.sqrt(2), np.sqrt(3), 89.0]
    assert metrics.point_distances(probes, *cube()) == pytest.approx(expected, rel=1e-6)


def test_distances_agree_with_brute_force_over_all_triangles():
    points, faces = shapes.l_bracket()
    probes = np.random.default_rng(5).uniform(-1, 5, size=(200, 3))
    found = metrics.point_distances(probes, points, faces)
    assert found == pytest.approx(brute_force_distances(probes, points, faces), rel=1e-6)


def brute_force_distances(probes, points, faces):
    """The least distance to any triangle: to its inside where the foot lies there, to its edges."""
    least = np.full(len(probes), np.inf)
    for a, b, c in points[faces]:
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal)
        height = (probes - a) @ normal
        foot = probes - height[:, None] * normal
        inside = np.ones(len(probes), dtype=bool)
        for p, q in ((a, b), (b, c), (c, a)):
            inside &= np.cross(q - p, foot - p) @ normal >= 0
            along = np.clip((probes - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
            least = np.minimum(least, np.linalg.norm(probes - p - along[:, None] * (q - p), axis=1))
        least = np.where(inside, np.minimum(least, np.abs(height)), least)
    return least


def test_distances_agree_with_meshlabs_hausdorff_filter():
    points, faces = shapes.unit_sphere(30)
    stretched = points * [1.0, 1.0, 1.1]
    found = metrics.distances(stretched, faces, points, faces)
    mesh_set = pymeshlab.MeshSet(verbose=False)
    mesh_set.add_mesh(pymeshlab.Mesh(points, faces))
    mesh_set.add_mesh(pymeshlab.Mesh(stretched, faces))
    theirs = mesh_set.get_hausdorff_distance(
        sampledmesh=1, targetmesh=0, samplevert=False, sampleface=True, samplenum=100_000
    )
    percent = 100 / geometry.diagonal(points)
    assert found["rms_to_surface"] == pytest.approx(theirs["RMS"] * percent, rel=0.01)
    assert found["max_to_surface"] == pytest.approx(theirs["max"] * percent, rel=0.01)


def test_samples_are_uniform_by_area():
    # One triangle three times the size of the other.
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [10, 0, 0], [13, 0, 0], [10, 1, 0]])
    faces = np.array([[0, 1, 2], [3, 4, 5]])
    drawn, normals = geometry.sample_surface(points, faces, 40_000, np.random.default_rng(0))
    # Four standard deviations of the share are 0.009.
    assert np.mean(drawn[:, 0] > 5) == pytest.approx(0.75, abs=0.009)
    small = drawn[drawn[:, 0] < 5]
    assert small.mean(axis=0) == pytest.approx([1 / 3, 1 / 3, 0], abs=0.01)
    assert np.allclose(normals, [0, 0, 1])


def test_topology_of_a_closed_genus_0_and_a_genus_1_mesh():
    found = metrics.topology(*cube())
    expected = {
        "self_intersecting": 0,
        "boundary_edges": 0,
        "non_manifold_edges": 0,
        "non_manifold_vertices": 0,
        "components": 1,
        "genus": 0,
    }
    assert found == expected
    ring = np.ones((3, 3, 1), dtype=bool)
    ring[1, 1, 0] = False
    frame = shapes.union_of_cells([0, 1, 2, 3], [0, 1, 2, 3], [0, 1], ring)
    assert metrics.topology(*frame)["genus"] == 1


def test_an_open_mesh_has_boundary_edges_and_no_genus():
    points, faces = cube()
    found = metrics.topology(points, faces[1:])
    assert found["boundary_edges"] == 3
    assert found["genus"] is None


def test_an_edge_of_four_faces_is_not_manifold():
    touching = np.array([[[True], [False]], [[False], [True]]])
    found = metrics.topology(*shapes.union_of_cells([0, 1, 2], [0, 1, 2], [0, 1], touching))
    assert found["non_manifold_edges"] == 1
    assert found["genus"] is None


def test_two_crossing_triangles_are_two_self_intersecting_faces():
    points = np.array(
        [[-1.0, -1, 0], [1, -1, 0], [0, 2, 0], [0, 0, -1], [0, 0, 1], [0, 5, 0.1]], dtype=float
    )
    found = metrics.topology(points, np.array([[0, 1, 2], [3, 4, 5]]))
    assert found["self_intersecting"] == 2
    assert found["components"] == 2


def test_angles_of_known_triangles():
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0.5, np.sqrt(0.75), 0], [2, 0, 0]])
    faces = np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    assert metrics.smallest_angles(points, faces) == pytest.approx([45, 60, 0], abs=1e-9)


def test_valences_of_an_octahedron_and_unused_vertices_do_not_count():
    _, faces = shapes.unit_sphere(1)
    assert metrics.valences(faces).tolist() == [4] * 6
    assert metrics.valences(faces + 3).tolist() == [4] * 6


def test_valences_of_a_subdivided_octahedron_are_6_but_at_its_corners():
    points, faces = shapes.unit_sphere(10)
    found = metrics.shape(points, faces)
    assert found["vertices"] == 402
    assert found["faces"] == 800
    assert found["valence_6"] == pytest.approx(100 * 396 / 402)


@pytest.mark.parametrize("make", [shapes.l_bracket, shapes.stepped_cube, shapes.thin_blade])
def test_generated_shapes_are_closed_genus_0_and_face_outwards(make):
    points, faces = make()
    found = metrics.topology(points, faces)
    assert (found["genus"], found["components"], found["self_intersecting"]) == (0, 1, 0)
    volume = np.einsum(
        "ij,ij->", np.cross(points[faces[:, 0]], points[faces[:, 1]]), points[faces[:, 2]]
    )
    assert volume > 0


def test_noise_and_outliers_are_what_the_condition_says_and_repeat():
    clean = inputs.make_case("bracket", "clean", 1)
    noisy = inputs.make_case("bracket", "noise0.5", 1)
    stray = inputs.make_case("bracket", "outliers", 1)
    size = geometry.diagonal(clean.reference_points)
    count = models.MODELS["bracket"].samples
    assert len(clean.points) == len(noisy.points) == count
    assert len(stray.points) == round(1.05 * count)
    # A standard deviation from 300,000 numbers is good to 0.13 %.
    assert np.std(noisy.points - clean.points) == pytest.approx(0.005 * size, rel=0.01)
    assert np.array_equal(noisy.points, stray.points[:count])
    assert np.array_equal(stray.points, inputs.make_case("bracket", "outliers", 1).points)
    assert not np.array_equal(noisy.points, inputs.make_case("bracket", "noise0.5", 2).points)
    low, high = clean.reference_points.min(axis=0), clean.reference_points.max(axis=0)
    reach = (stray.points[count:] - (low + high) / 2) / (high - low)
    assert np.abs(reach).max(axis=0) == pytest.approx([0.55] * 3, abs=0.002)


def test_uneven_points_are_ten_times_as_dense_at_one_end_and_sparse_ones_are_few():
    uneven = inputs.make_case("bracket", "uneven", 1)
    assert len(uneven.points) == models.MODELS["bracket"].samples
    low, high = uneven.reference_points.min(axis=0), uneven.reference_points.max(axis=0)
    axis = int(np.argmax(high - low))
    even = inputs.make_case("bracket", "clean", 1)
    ends = []
    for case in (uneven, even):
        along = (case.points[:, axis] - low[axis]) / (high - low)[axis]
        ends.append([np.mean(along < 0.1), np.mean(along > 0.9)])
    (sparse_end, dense_end), (first, last) = ends
    # The ramp is that of whole faces, which are a twentieth of the side long or less.
    assert (dense_end / last) / (sparse_end / first) == pytest.approx(10**0.9, rel=0.3)
    sparse = inputs.make_case("bunny", "sparse", 1)
    assert len(sparse.points) == len(sparse.normals) == 3_000


@pytest.mark.usefixtures("few_samples")
def test_poisson_at_its_best_is_the_setting_with_the_least_error_and_says_which():
    case = inputs.make_case("step", "clean", 1)
    best = methods.TABLE_METHODS["poisson-best"]
    errors = {}
    for setting in best.settings:
        row = measure_row(Job(setting, case, methods.Task(400)))
        assert row["setting"] is None
        errors[setting.label] = row["rms_to_mesh"] * row["rms_to_surface"]
    assert len(errors) == 6
    row = measure_row(Job(best, case, methods.Task(400)))
    assert row["setting"] == min(errors, key=errors.__getitem__)
    assert row["vertices"] == 400
    assert row["rms_to_mesh"] * row["rms_to_surface"] == pytest.approx(min(errors.values()))


def test_outliers_are_removed_only_where_there_are_some():
    points = np.vstack([shapes.unit_sphere(20)[0], [[9.0, 9.0, 9.0]]])
    for known in (False, True):
        document = layers.document_of(points)
        methods.remove_known_outliers(document, methods.Task(400, outliers=known))
        furthest = np.abs(document.current_mesh().vertex_matrix()).max()
        assert bool(furthest > 2) is not known


@pytest.fixture
def few_samples(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take 4,000 points instead of 100,000 from the stepped cube: rows in a second."""
    monkeypatch.setitem(
        models.MODELS, "step", dataclasses.replace(models.MODELS["step"], samples=4_000)
    )


@pytest.mark.usefixtures("few_samples")
def test_a_peers_row_has_the_asked_count_and_comes_from_the_cache_the_second_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    settings = Settings(plugin=Path(), timeout=120)
    arguments = (Group("step", "clean", 1, 400), [Variant("poisson-true")], settings)
    (first,) = run_group(*arguments)
    (second,) = run_group(*arguments)
    assert not first.failed, first.values
    assert first.values["vertices"] == 400
    assert first.values["genus"] == 0
    assert (first.from_cache, second.from_cache) == (False, True)
    assert first.values == second.values


@pytest.mark.usefixtures("few_samples")
def test_a_method_that_fails_is_a_row_and_not_the_end():
    settings = Settings(plugin=Path("no-such-plugin.so"), timeout=120)
    group = Group("step", "clean", 1, 400)
    rows = list(run_group(group, [Variant("ours")], settings))
    assert rows[0].failed
    assert "failed: " in report.group_markdown(group, rows)


@pytest.mark.usefixtures("few_samples")
def test_a_method_that_takes_too_long_is_a_row():
    settings = Settings(plugin=Path(), timeout=0.01, fresh=True)
    group = Group("step", "clean", 1, 40)
    rows = list(run_group(group, [Variant("ball-pivoting")], settings))
    assert rows[0].values["failure"] == "It timed out: it was not done after 0.01 s."


def row(model: str, method: str, seed: int = 1, **values: Any) -> Row:
    """A made-up clean row."""
    return Row(Group(model, "clean", seed, 5000), method, values)


def test_the_overview_takes_the_geometric_mean_of_the_seeds():
    rows = [
        row("dino", "ours", rms_to_mesh=0.02, rms_to_surface=0.1),
        row("dino", "ours", seed=2, rms_to_mesh=0.08, rms_to_surface=0.1),
        row("dino", "poisson-true", rms_to_mesh=0.01, rms_to_surface=0.01),
        row("dino", "poisson-true", seed=2, failure="crashed with SIGSEGV"),
    ]
    assert report.overview_markdown(rows).splitlines()[-1] == "| dino | 0.040 / 0.100 | – |"


def test_handles_are_counted_against_those_of_the_model():
    assert bounds.wrong_handles(row("anchor", "ours", genus=4)) == 0
    assert bounds.wrong_handles(row("anchor", "ours", genus=1)) == 3
    assert bounds.wrong_handles(row("bunny", "ours", genus=None)) == np.inf


def test_bounds_take_the_geometric_mean_and_the_worst_and_count_failures():
    rows = [
        row("bunny", "ours", rms_to_mesh=0.2),
        row("bunny", "poisson-true", rms_to_mesh=0.1),
        row("dino", "ours", rms_to_mesh=0.05),
        row("dino", "poisson-true", rms_to_mesh=0.1),
    ]
    table = bounds.Rows(rows)
    mean, worst = bounds.clean_models(table)
    assert mean.measured.startswith("1.00 (2 models: dino 0.50 … bunny 2.00")
    assert mean.kept
    assert worst.measured.startswith("2.00")
    assert worst.kept is False
    rows[2] = row("dino", "ours", failure="crashed with SIGSEGV")
    assert bounds.clean_models(bounds.Rows(rows))[0].kept is False
    assert bounds.clean_models(bounds.Rows(rows[1:2]))[0].measured == "not measured"
