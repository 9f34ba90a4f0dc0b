# SPDX-License-Identifier: GPL-3.0-or-later
"""What the topology table measures and judges, on clouds and meshes whose answers are known."""

from __future__ import annotations

import dataclasses
import itertools
from typing import Any

import numpy as np
import pymeshlab
import pytest

from neuralmesh_tools import generated_clouds as clouds
from neuralmesh_tools import geometry
from neuralmesh_tools.benchmarks.topology import data, judge, report, run
from neuralmesh_tools.benchmarks.topology.rows import FACE_GAPS, ROWS, Expected
from neuralmesh_tools.quality import shapes

RIGHT: dict[str, Any] = {
    "vertices": 5_000,
    "components": 1,
    "genus": 0,
    "loops": 0,
    "two_manifold": True,
    "oriented": True,
    "self_intersecting": 0,
    "covered": 1.0,
    "coverage": 1.0,
    "unsupported_area": 0.0,
    "volume": 1.0,
    "diagonal": 1.0,
    "in_window": 0,
    "cpu_seconds": 2.0,
}


def run_of(condition: str = "clean", row: str = "bunny", **values: Any) -> judge.Run:
    """A made-up run, right but for the values given."""
    return judge.Run(row, condition, 1, 5_000, RIGHT | values)


def test_points_of_a_torus_are_on_it_and_uniform_by_area():
    points = clouds.torus(40_000, 1)
    distance = np.hypot(points[:, 0], points[:, 1])
    assert np.hypot(distance - 1, points[:, 2]) == pytest.approx(0.4)
    # The outer half has 2 pi * 0.4 * (pi + 0.8) of 4 pi^2 * 0.4; four standard deviations 0.01.
    assert np.mean(distance > 1) == pytest.approx((np.pi + 0.8) / (2 * np.pi), abs=0.01)


def test_twenty_spheres_keep_apart_and_have_points_by_area():
    points = clouds.twenty_spheres(4_000, 1)
    assert len(np.unique(points.round(9), axis=0)) == 4_000
    assert not np.array_equal(points, clouds.twenty_spheres(4_000, 2))


@pytest.mark.parametrize("half_angle", [60, 90])
def test_a_cap_ends_at_its_angle(half_angle: float):
    points = clouds.cap(4_000, 1, half_angle)
    assert np.linalg.norm(points, axis=1) == pytest.approx(1)
    # The lowest of 4,000 uniform heights is within 10 / 4,000 of the range.
    lowest = np.cos(np.radians(half_angle))
    assert lowest <= points[:, 2].min() < lowest + 0.0025 * (1 - lowest)


def test_a_cup_has_its_points_on_five_surfaces_by_area():
    points, wall = clouds.cup(40_000, 1, 0.3), 0.3
    radius, height = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    outer = np.isclose(radius, 1) & (height < 2)
    inner = np.isclose(radius, 1 - wall) & (height > wall)
    bottoms = np.isclose(height, 0) | np.isclose(height, wall)
    rim = np.isclose(height, 2)
    assert np.all(outer | inner | bottoms | rim)
    assert radius[rim].min() >= 1 - wall
    areas = {"outer": 4, "inner": 2 * 0.7 * 1.7, "bottoms": 1 + 0.49, "rim": 1 - 0.49}
    counts = {"outer": outer, "inner": inner, "bottoms": bottoms, "rim": rim}
    for name, area in areas.items():
        # Four standard deviations of a share are at most 0.01.
        share = area / sum(areas.values())
        assert np.mean(counts[name]) == pytest.approx(share, abs=0.01), name


def test_a_cups_volume_is_that_of_its_outside_without_its_inside():
    assert clouds.cup_volume(0.3) == pytest.approx(np.pi * (2 - 0.49 * 1.7))


def test_conditions_are_what_they_say():
    clean = data.made(ROWS["torus"].maker, 5_000, "clean", 1)
    noisy = data.made(ROWS["torus"].maker, 5_000, "noise", 1)
    stray = data.made(ROWS["torus"].maker, 5_000, "outliers", 1)
    sparse = data.made(ROWS["torus"].maker, 5_000, "sparse", 1)
    assert np.array_equal(clean.points, clean.clean)
    assert np.array_equal(noisy.clean, clean.clean)
    # A standard deviation from 15,000 numbers is good to 0.6 %.
    expected = 0.002 * geometry.diagonal(clean.clean)
    assert np.std(noisy.points - noisy.clean) == pytest.approx(expected, rel=0.025)
    assert np.array_equal(stray.points[:5_000], clean.clean)
    assert (len(stray.points), len(sparse.points)) == (5_250, 3_000)
    half = data.made(ROWS["torus"].maker, 5_000, "half", 1)
    # Of the two sides that are equally long, either may be the longest.
    low = min((half.points[:, axis] < 0).sum() for axis in (0, 1))
    assert (low, len(half.points) - low) == (
        pytest.approx(250, abs=60),
        pytest.approx(2_500, abs=60),
    )
    assert len(half.clean) == 5_000


def test_outliers_of_a_plane_lie_on_both_sides_of_it():
    cloud = data.made(ROWS["flat-square"].maker, 5_000, "outliers", 1)
    reach = cloud.points[5_000:, 2]
    # The least and the greatest of 250 uniform heights are within 4 % of the ends, nearly always.
    assert (reach.min(), reach.max()) == pytest.approx((-0.05, 0.05), abs=0.004)


def test_zeros_far_away_do_not_make_the_noise_larger():
    cloud = data.made(ROWS["zeros-10km"].maker, 5_000, "noise", 1)
    assert np.all(cloud.points[-30:] == 0)
    assert len(cloud.points) == 5_030
    assert np.abs(cloud.points[:5_000] - cloud.clean).max() < 0.05


def test_topology_of_open_meshes_is_counted():
    points, faces = shapes.unit_sphere(8)
    near_pole = np.isclose(points[faces][:, :, 2], points[:, 2].max()).any(axis=1)
    near_foot = np.isclose(points[faces][:, :, 2], points[:, 2].min()).any(axis=1)
    found = run.topology(points, faces[~near_pole & ~near_foot])
    assert (found["components"], found["genus"], found["loops"]) == (1, 0, 2)
    assert found["two_manifold"]
    frame_points, frame_faces = shapes.picture_frame(0.3)
    both = np.vstack([points, frame_points + 5])
    found = run.topology(both, np.vstack([faces, frame_faces[1:] + len(points)]))
    assert (found["components"], found["genus"], found["loops"]) == (2, 1, 1)


def test_a_face_turned_round_is_not_oriented():
    points, faces = shapes.unit_sphere(4)
    assert run.topology(points, faces)["oriented"]
    turned = faces.copy()
    turned[0] = turned[0, ::-1]
    assert not run.topology(points, turned)["oriented"]


def test_volume_and_window_of_a_frame():
    points, faces = shapes.picture_frame(0.5)
    assert run.volume(points, faces) == pytest.approx(0.5 * (4 - 1))
    assert run.faces_in_window(points, faces, 0.45) == 0
    # A lid over the hole: its two faces, and no others, have their centres in there.
    corners = np.array([[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0]])
    lid = np.array([[0, 1, 2], [0, 2, 3]]) + len(points)
    window = run.faces_in_window(np.vstack([points, corners]), np.vstack([faces, lid]), 0.45)
    assert window == 2


def test_what_lies_beyond_a_border_is_not_covered():
    # A square of 20 x 20 cells of an edge of 1, and points up to 5 beyond one of its sides.
    points, faces = grid(20)
    generator = np.random.default_rng(1)
    drawn = np.c_[generator.uniform([0, 0], [25, 20], (20_000, 2)), np.zeros(20_000)]
    edge = (2 + np.sqrt(2)) / 3
    # The mean edge is that of two sides a cell and one diagonal, but for the border.
    assert run.covered(drawn, points, faces) == pytest.approx((20 + edge / 2) / 25, abs=0.01)


def grid(cells: int):
    """A square of so many cells a side, each of two triangles."""
    index = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    points = np.array(list(itertools.product(range(cells + 1), range(cells + 1), [0])), dtype=float)
    a, b, c, d = (
        index[i : cells + i, j : cells + j].ravel() for i, j in [(0, 0), (1, 0), (1, 1), (0, 1)]
    )
    return points, np.vstack([np.c_[a, b, c], np.c_[a, c, d]]).astype(np.int32)


@pytest.mark.parametrize(
    ("values", "fault"),
    [
        ({"vertices": 4_999}, "4,999 vertices"),
        ({"two_manifold": False}, "not two-manifold"),
        ({"oriented": False}, "not oriented"),
        ({"self_intersecting": 2}, "crossing faces"),
        ({"components": 2}, "2 components"),
        ({"genus": 1}, "genus 1"),
        ({"loops": 3}, "3 loops"),
        ({"covered": 0.981}, "covered 98.1 %"),
        ({"unsupported_area": 0.31}, "unsupported 31 %"),
        ({"volume": 1.06}, "volume +6 %"),
        ({"diagonal": 0.9}, "diagonal -10 %"),
        ({"in_window": 1}, "faces across the hole"),
    ],
)
def test_each_thing_that_is_wrong_is_named(values: dict[str, Any], fault: str):
    sizes = {"volume": 1.0, "diagonal": 1.0}
    expected = Expected(loops=(0, 2), whole=True, no_surplus=True, **sizes)
    assert judge.faults(run_of(), expected) == []
    assert judge.faults(run_of(**values), expected) == [fault]


def test_holes_of_the_face_scan_are_as_large_as_the_table_says():
    cloud = data.scan("face")(10**9, 1)
    pieces = pymeshlab.MeshSet(verbose=False)
    pieces.add_mesh(pymeshlab.Mesh(*cloud.surface))
    pieces.generate_splitting_by_connected_components(delete_source_mesh=True)
    pieces.set_current_mesh(max(pieces, key=lambda piece: piece.vertex_number()).id())
    pieces.meshing_repair_non_manifold_edges()
    pieces.meshing_repair_non_manifold_vertices()
    # Its border has 2,479 edges, the longest hole 227.
    opened = pieces.get_geometric_measures()["surface_area"]
    pieces.meshing_close_holes(maxholesize=1000, selfintersection=False)
    closed = pieces.get_geometric_measures()["surface_area"]
    assert 1 - opened / closed == pytest.approx(FACE_GAPS, abs=0.0005)


def test_holes_of_the_data_that_are_to_be_closed_are_no_surplus():
    closed = run_of(unsupported_area=0.11)
    assert judge.faults(closed, Expected(no_surplus=True)) == ["unsupported 11 %"]
    assert judge.faults(closed, Expected(no_surplus=True, gaps=0.07)) == []


def test_crossing_faces_are_borne_under_noise_unless_none_may_be():
    crossing = run_of("noise", self_intersecting=2)
    assert judge.faults(crossing, Expected()) == []
    assert judge.faults(crossing, Expected(no_crossing=True)) == ["crossing faces"]


def test_one_run_less_has_to_be_right_where_points_are_not_clean():
    assert [judge.needed("bunny", name, 5) for name in data.CONDITIONS] == [5, 4, 4, 4, 4]
    assert [judge.needed("turbine", "clean", runs) for runs in (1, 2, 3, 5)] == [1, 2, 2, 3]


def test_a_row_misses_its_bar_by_shape_and_by_time():
    right, wrong = run_of(), run_of(genus=1)
    assert judge.missed([right] * 5, 0.4) == []
    assert judge.missed([right] * 4 + [wrong], 0.4) == ["4 of 5 right, not 5"]
    assert judge.missed([run_of(cpu_seconds=6.5)], 0.4) == ["3.2 × the bunny's time"]
    failed = dataclasses.replace(right, values={"failure": "It was killed."})
    assert judge.missed([failed], 0.4) == ["0 of 1 right, not 1"]


def test_a_line_says_what_the_others_are_and_how_many():
    runs = [run_of(), run_of(genus=1), run_of(genus=1), run_of(genus=2, self_intersecting=4)]
    cells = [cell.strip() for cell in report.line(runs, 0.4).strip("|").split("|")]
    found = dict(zip(report.HEADINGS, cells, strict=True))
    assert found["right"] == "1 of 4"
    assert found["otherwise"] == "genus 1 (×2); crossing faces, genus 2 (×1)"
    assert found["self-int."] == "4"
    assert found["missed"] == "1 of 4 right, not 4"


def test_the_overview_is_bold_where_too_few_runs_are_right():
    runs = [run_of(), run_of(genus=1), run_of("noise"), run_of(row="torus", genus=1)]
    assert report.overview(runs).splitlines() == [
        "| data | expected | clean | σ = 0.2 % |",
        "|---|---|--:|--:|",
        "| bunny | genus 0, closed | **1 of 2** | 1 of 1 |",
        "| torus | genus 1, closed | 1 of 1 |  |",
    ]
