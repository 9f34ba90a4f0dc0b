# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/benchmark.py --scale: which cases there are, and that a row is of what it says."""

from __future__ import annotations

import subprocess
import sys

from neuralmesh_tools.benchmarks.scale import Case, cases
from neuralmesh_tools.project import SCRIPTS


def test_clouds_have_8_points_a_vertex_and_no_fewer_than_100_000() -> None:
    assert cases([1000, 100_000], [2_000_000], [1, 2]) == [
        Case(1000, 100_000, 1),
        Case(1000, 100_000, 2),
        Case(100_000, 800_000, 1),
        Case(100_000, 800_000, 2),
        Case(5000, 2_000_000, 1),
        Case(5000, 2_000_000, 2),
    ]


def test_prints_a_row_for_each_case() -> None:
    command = [sys.executable, str(SCRIPTS / "benchmark.py"), "--scale", "--runs", "1"]
    command += ["--scale-vertices", "200", "--scale-points", "20000", "--scale-threads", "1"]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = [[cell.strip() for cell in line.split("|")] for line in output.splitlines()[2:]]
    assert [row[1:4] for row in rows] == [["200", "100,000", "1"], ["5,000", "20,000", "1"]]
    assert all(float(row[4]) > 0 for row in rows)
