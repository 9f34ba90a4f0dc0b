# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/benchmark.py --shapes: the clouds, and that a row is of what it says."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from neuralmesh_tools.benchmarks.shapes.data import BENIGN, SHAPES
from neuralmesh_tools.project import SCRIPTS


def test_there_are_24_shapes() -> None:
    assert len(SHAPES) == 24


@pytest.mark.parametrize("shape", SHAPES)
def test_a_shape_has_the_points_asked_for_and_is_no_sphere(shape: str) -> None:
    points = SHAPES[shape](2000, 1)
    assert points.shape == (2000, 3)
    assert np.isfinite(points).all()
    assert np.ptp(points, axis=0).max() > 0
    assert not np.array_equal(points, BENIGN(2000, 1))


def test_prints_a_row_for_each_shape_beside_the_sphere() -> None:
    command = [sys.executable, str(SCRIPTS / "benchmark.py"), "--shapes", "--runs", "1"]
    command += ["--kinds-of-shapes", "flat-square,chain", "--shape-points", "5000"]
    command += ["--vertices", "500"]
    output = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    rows = [[cell.strip() for cell in line.split("|")] for line in output.splitlines()[2:5]]
    assert [row[1] for row in rows] == ["sphere", "flat-square", "chain"]
    assert float(rows[0][3]) == 1
    assert all(float(row[2]) > 0 for row in rows)
    assert rows[0][4:7] == ["0", "1", "0"]
    assert float(rows[0][7]) > 99
