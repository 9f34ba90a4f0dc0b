# SPDX-License-Identifier: GPL-3.0-or-later
"""`neuralmesh compare`: clouds of any format beside PyMeshLab's filters, without the plugin."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import commands
import numpy as np
import pytest
from neuralmesh.command import comparisons, main
from point_files import WRITERS, Colours, Points

from neuralmesh_tools.comparison.clouds import load_cloud_by_package


@pytest.mark.parametrize(("name", "writer"), [row[:2] for row in WRITERS])
def test_every_format_is_a_cloud_with_normals(
    name: str, writer: Callable[[Path, Points, Colours], None], ball: Points, tmp_path: Path
) -> None:
    points = np.round(ball[:300], 6)
    writer(tmp_path / name, np.vstack([points, points[:20]]), np.full((320, 3), 100, np.uint8))
    cloud = load_cloud_by_package(str(tmp_path / name))
    assert cloud.points == pytest.approx(points, abs=1e-6)
    outward = np.sum(cloud.normals * points, axis=1)
    # The 16 nearest of 300 points on a sphere span 35 degrees or so: the plane tilts by less.
    assert np.median(outward) > 0.95


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("a.laz", b"hello", "It is no LAS or LAZ file: "),
        (
            "a.csv",
            b"1,2,nan\n4,5,6\n",
            "1 of its points have coordinates that are NaN or inf",
        ),
        ("a.xyz", b"1 2 3\n", "It holds 1 points; 17 are the least."),
        ("a.ply", b"ply\nformat ascii 1.0\nend_header\n", "It cannot be read: "),
    ],
)
def test_a_cloud_that_cannot_be_used_is_a_sentence(
    name: str, content: bytes, sentence: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(ValueError, match=sentence):
        load_cloud_by_package(str(tmp_path / name))


def test_ours_stands_beside_the_filters_of_pymeshlab(ball: Points, tmp_path: Path) -> None:
    np.save(tmp_path / "ball.npy", ball[:1000])
    methods = "neural-mesh,poisson"
    arguments = (tmp_path / "ball.npy", "--out", tmp_path / "out", "--methods", methods)
    run = commands.run("compare", *arguments, "--vertices", 200)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "neuralmesh compare " in (tmp_path / "out" / "report.html").read_text("utf-8")
    found = json.loads((tmp_path / "out" / "results.json").read_text("utf-8"))
    results = {row["method"]: row["values"] for row in found["clouds"][0]["results"]}
    assert list(results) == methods.split(",")
    assert results["neural-mesh"]["vertices"] == 200
    # Faces of 400 are chords: those of a regular mesh lie 0.3 % of the diagonal inside, by half.
    assert results["neural-mesh"]["rms_percent"] < 0.3
    again = commands.run("compare", *arguments, "--vertices", 200)
    assert "ball: done before" in again.stdout


def test_a_package_that_is_missing_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(comparisons, "NEEDED", ("numpy", "no_such_package"))
    assert main(["compare", "a.ply", "--out", "out"]) == 2
    told = capsys.readouterr().err
    assert "it needs no_such_package: pip install 'neuralmesh[compare]'." in told


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [(["--help"], 0, "usage: neuralmesh compare"), (["a.ply"], 2, "required: --out")],
)
def test_help_and_usage_need_no_more_packages(arguments: list[str], code: int, told: str) -> None:
    missing = (*comparisons.NEEDED, "psutil")
    program = (
        f"import sys; sys.modules.update(dict.fromkeys({missing}))\n"
        f"from neuralmesh.command import main; sys.exit(main(['compare', *{arguments}]))"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=100, check=False
    )
    assert run.returncode == code, run.stderr
    assert told in run.stdout + run.stderr
