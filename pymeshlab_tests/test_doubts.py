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
    warnings = {row["name"]: row["warning"] for row in csv_rows(out)}
    assert warnings["ball"] == ""
    assert warnings["half"].endswith("% of the mesh lies where there are no points.")
