# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflows of .github: well formed, and of the same versions as everything else."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from neuralmesh_tools.project import ROOT

WORKFLOWS = sorted((ROOT / ".github").glob("workflows/*.yml"))
ACTION = ROOT / ".github/actions/sources/action.yml"
TEXT = "\n".join(path.read_text("utf-8") for path in [*WORKFLOWS, ACTION])
TOOLS = Path(sys.executable).parent


def pinned(package: str) -> str:
    """The version of a package in requirements.txt."""
    text = (ROOT / "requirements.txt").read_text("utf-8")
    found = re.search(rf"^{package}==(\S+)$", text, re.MULTILINE)
    assert found
    return found[1]


def of_setup(variable: str) -> str:
    """The value of a variable of scripts/setup."""
    found = re.search(rf"{variable}=(\S+)", (ROOT / "scripts/setup").read_text("utf-8"))
    assert found
    return found[1]


def test_actionlint_finds_nothing() -> None:
    actionlint = TOOLS / "actionlint"
    if not actionlint.is_file():
        pytest.skip("scripts/setup builds actionlint where Go is installed, and here it is not")
    run = subprocess.run([actionlint], cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.stdout + run.stderr == ""
    assert run.returncode == 0


def test_sources_are_those_of_the_setup() -> None:
    assert f"ref: MeshLab-{of_setup('meshlab_version')}\n" in TEXT
    assert f"ref: v{of_setup('muparser_version')}\n" in TEXT
    for repository in ("meshlab", "muparser"):
        name = of_setup(f"{repository}_repository").removeprefix("https://github.com/")
        assert f"repository: {name}\n" in TEXT


def test_packages_are_those_of_the_tests() -> None:
    assert f"PYMESHLAB: pymeshlab=={pinned('pymeshlab')}\n" in TEXT
    assert f"pip install cibuildwheel=={pinned('cibuildwheel')}\n" in TEXT


def test_files_and_presets_that_they_name_are_there() -> None:
    names = set(re.findall(r"scripts/[\w./]+", TEXT))
    assert len(names) >= 3
    assert [name for name in names if not (ROOT / name).exists()] == []
    presets = (ROOT / "CMakePresets.json").read_text("utf-8")
    named = set(re.findall(r"--preset (\w+)", TEXT)) | {"pymeshlab", "meshlab"}
    assert [name for name in named if f'"{name}"' not in presets] == []
    assert "host: [pymeshlab, meshlab]" in TEXT


@pytest.mark.parametrize(
    ("system", "tag"),
    [("linux", "manylinux_x86_64"), ("macos", "macosx_x86_64"), ("windows", "win_amd64")],
)
def test_wheels_are_made_for_each_python_until_one_is_for_all(system: str, tag: str) -> None:
    command = [TOOLS / "cibuildwheel", "--print-build-identifiers", "--platform", system]
    command += ["--archs", "AMD64" if system == "windows" else "x86_64", "python/neuralmesh"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert run.stdout.split() == [f"cp3{minor}-{tag}" for minor in (10, 11, 12)]
    project = tomllib.loads((ROOT / "python/neuralmesh/pyproject.toml").read_text("utf-8"))
    assert project["tool"]["scikit-build"]["wheel"]["py-api"] == "cp312"
    assert project["project"]["requires-python"] == ">=3.10"
