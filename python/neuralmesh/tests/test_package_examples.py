# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/examples/conversions: each runs as it stands, and makes what it says."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import neuralmesh
import pytest

from neuralmesh_tools.project import ROOT, SCRIPTS

EXAMPLES = SCRIPTS / "examples/conversions"
# What each prints, in part, and writes.
PROMISES = {
    "functions.py": ("terrain: 1000 vertices, genus 0, 1 boundary loops", "gyroid.ply"),
    "with_trimesh.py": ("watertight: True Euler number: 0", "trimesh.glb"),
    "with_pyvista.py": ("open edges: 0 points: 1000 manifold: True", "pyvista.vtp"),
    "with_pymeshlab.py": ("genus: 1 boundary edges: 0", "pymeshlab.ply"),
    "with_open3d.py": ("watertight: True Euler number: 0", "open3d.ply"),
}


@pytest.mark.parametrize("name", PROMISES)
def test_example(name: str, tmp_path: Path) -> None:
    if name == "with_open3d.py" and find_spec("open3d") is None:
        pytest.skip("open3d, of 400 MB, is not among the packages of requirements.txt")
    run = subprocess.run(
        [sys.executable, EXAMPLES / name],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    printed, written = PROMISES[name]
    assert printed in run.stdout
    assert (tmp_path / "out" / written).stat().st_size > 1000
    if written.endswith((".ply", ".glb")):
        assert len(neuralmesh.read(tmp_path / "out" / written).points) >= 1000


def test_every_example_is_tested_and_listed() -> None:
    names = {path.name for path in EXAMPLES.glob("*.py")}
    assert names == set(PROMISES)
    listed = (ROOT / "docs/python.md").read_text("utf-8")
    assert [name for name in names if f"`{name}`" not in listed] == []


def test_the_readme_of_the_package_runs_as_printed(tmp_path: Path) -> None:
    text = (ROOT / "python/neuralmesh/README.md").read_text("utf-8")
    (code,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True, timeout=100)
    assert len(neuralmesh.read(tmp_path / "ball.ply").points) == 2000
