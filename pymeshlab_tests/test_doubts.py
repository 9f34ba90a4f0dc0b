# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that are not to be trusted say so, in a batch too."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from batches import csv_rows, report, run_batch
from documents import sphere_points

from neuralmesh_tools.doubts import LEAST_COVERAGE, MOST_UNSUPPORTED, doubts
from neuralmesh_tools.project import ROOT

GOOD = {"coverage": 0.99, "unsupported_area": 0.01, "self_intersections": 0, "reached_target": True}


@pytest.mark.parametrize(
    ("figures", "sentence"),
    [
        ({}, ""),
        ({"coverage": 0.64}, "36% of the points are not near the mesh."),
        ({"unsupported_area": 0.31}, "31% of the mesh lies where there are no points."),
        ({"self_intersections": 1680}, "1,680 faces intersect another."),
        ({"reached_target": False}, "It does not have the number of vertices asked for."),
    ],
)
def test_each_doubt_has_a_sentence(figures: dict[str, object], sentence: str) -> None:
    assert doubts(GOOD | figures) == sentence


LOG = (
    "LOG: 2 Neural mesh: 5 vertices. It was learned from the data. Warning: the points leave the "
    "shape open: handles or parts may be missing, or too many. More points may help. Warning: 33 % "
    "of the mesh lies where there are no points: it closes holes. Try 1.5 of it.\n"
    "Warning: parameter x not required by filter y\n"
)


def test_warnings_of_the_log_are_doubts_and_none_is_told_twice() -> None:
    shape = "The points leave the shape open: handles or parts may be missing, or too many."
    assert doubts(GOOD, LOG) == shape
    unsupported = "31% of the mesh lies where there are no points."
    assert doubts(GOOD | {"unsupported_area": 0.31}, LOG) == f"{unsupported} {shape}"
    # A filter script returns no figures: the log tells all.
    assert doubts({}, LOG) == (
        f"{shape} 33 % of the mesh lies where there are no points: it closes holes."
    )


def test_a_filter_that_reports_nothing_raises_no_doubt() -> None:
    assert doubts({"vertices": 100}) == ""


def test_doubts_begin_where_the_filters_own_do() -> None:
    source = (ROOT / "filter_neuralmesh/hosts/common/reconstruction.cpp").read_text(
        encoding="utf-8"
    )
    assert f"leastCoverage = {LEAST_COVERAGE};" in source
    assert f"mostUnsupported = {MOST_UNSUPPORTED};" in source


@pytest.mark.usefixtures("plugin")
def test_a_batch_names_the_scans_that_it_doubts(tmp_path: Path) -> None:
    clouds, out = tmp_path / "clouds", tmp_path / "out"
    clouds.mkdir()
    ball = sphere_points(8000)
    np.savetxt(clouds / "ball.xyz", ball)
    np.savetxt(clouds / "half.xyz", ball[ball[:, 2] > 0])
    run = run_batch(clouds, "--out", out, "--vertices", 500, "--set", "topology=0")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "half: " in run.stdout
    assert "ball: " not in run.stdout
    assert "2 done, 1 of them with a warning, 0 failed" in run.stdout
    assert report(out)["doubtful"] == 1
    ball = report(out)["records"][0]["results"]
    # Of a sphere of diagonal 2 √3.
    percent = ball["rms_error_percent"] / 100
    assert percent == pytest.approx(ball["rms_error"] / (2 * np.sqrt(3)), rel=0.01)
    warnings = {row["name"]: row["warning"] for row in csv_rows(out)}
    assert warnings["ball"] == ""
    assert warnings["half"].endswith("% of the mesh lies where there are no points.")


SCRIPT = """<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Neural Mesh Reconstruction">
  <Param name="TargetVertNum" type="RichInt" value="400"/>
 </filter>
</FilterScript>
"""


@pytest.mark.usefixtures("plugin")
def test_a_batch_warns_of_a_shape_that_the_points_leave_open(tmp_path: Path) -> None:
    points = np.vstack([sphere_points(3000), 0.88 * sphere_points(3000)])
    np.savetxt(tmp_path / "shells.xyz", points)
    (tmp_path / "script.mlx").write_text(SCRIPT, encoding="utf-8")
    script = ("--mlx", tmp_path / "script.mlx")
    for number, options in enumerate((script, ("--vertices", 400))):
        out = tmp_path / f"out{number}"
        run = run_batch(tmp_path / "shells.xyz", "--out", out, *options)
        assert run.returncode == 0, run.stdout + run.stderr
        (row,) = csv_rows(out)
        assert "The points leave the shape open: handles or parts may be" in row["warning"]
        assert "The points leave the shape open: handles or parts may be" in run.stdout
        assert "Neural mesh: 400 vertices" in (out / "logs" / "shells.log").read_text()
