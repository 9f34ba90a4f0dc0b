# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's table and figures come out as one page, and the table says what was measured."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from neuralmesh_tools.paper.reported import TABLE_1, Row
from neuralmesh_tools.paper.runs import DEFAULTS, PAPERS, valence_counts
from neuralmesh_tools.project import SCRIPTS


def run_script(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run scripts/reproduce_paper.py and return what it printed."""
    return subprocess.run(
        [sys.executable, SCRIPTS / "reproduce_paper.py", *arguments],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


@pytest.mark.parametrize("row", TABLE_1, ids=lambda row: row.title)
def test_reported_rows_add_up(row: Row) -> None:
    # Each row of the paper's table holds one vertex more than its name says.
    assert sum(row.counts) == row.vertices + 1


@pytest.mark.parametrize("setting", [PAPERS, DEFAULTS], ids=lambda setting: setting.title)
def test_all_vertices_are_counted_by_valence(setting: object, plugin: Path) -> None:
    counts = valence_counts("bunny", 300, setting)
    assert sum(counts) == 300
    # Most have valences 5 to 7; the paper has 95 % on larger meshes.
    assert sum(counts[1:4]) > 0.85 * 300


def test_a_small_page_holds_table_and_pictures_and_needs_no_other_file(
    plugin: Path, tmp_path: Path
) -> None:
    run = run_script("--out", str(tmp_path), "--scale", "0.05", "--models", "sphere,bunny")
    assert run.returncode == 0, run.stderr
    page = (tmp_path / "paper.html").read_text(encoding="utf-8")
    # Figures 9 and 10 with two settings each; the others need the head or the dinosaur.
    assert re.findall(r"<h2>Figure (\d+)", page) == ["9", "10"]
    assert len(re.findall(r'<img [^>]*src="data:image/png;base64,', page)) == 4
    assert not re.search(r'(src|href)="(?!data:)', page)
    assert len(list(tmp_path.glob("figure-*.png"))) == 4
    # Two rows of each model, three lines each.
    assert page.count("<tr") == 1 + 4 * 3
    for row in ("Sphere 50 ", "Sphere 250 ", "Bunny 50 ", "Bunny 250 "):
        assert row in run.stdout


@pytest.mark.parametrize(
    "arguments", [["--scale", "0"], ["--models", "moon"], ["--scale", "2"]], ids=" ".join
)
def test_wrong_usage_exits_with_2(arguments: list[str], tmp_path: Path) -> None:
    assert run_script("--out", str(tmp_path), *arguments).returncode == 2
