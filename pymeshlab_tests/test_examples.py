# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run as they stand, from a folder that shows the build as the project's root does."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pymeshlab
import pytest

EXAMPLES = sorted((Path(__file__).parent / "examples").glob("example_*.py"))


def test_there_are_examples() -> None:
    assert EXAMPLES


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs_and_saves_closed_meshes(example: Path, plugin: Path, tmp_path: Path) -> None:
    (tmp_path / "build").symlink_to(plugin.parent.parent, target_is_directory=True)
    run = subprocess.run(
        [sys.executable, str(example)],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    saved = list(tmp_path.glob("*.ply"))
    assert saved
    for path in saved:
        document = pymeshlab.MeshSet(verbose=False)
        document.load_new_mesh(str(path))
        measured = document.get_topological_measures()
        assert measured["faces_number"] > 0
        assert measured["boundary_edges"] == 0
        assert measured["is_mesh_two_manifold"]
