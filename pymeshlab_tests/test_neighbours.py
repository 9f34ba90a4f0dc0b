# SPDX-License-Identifier: GPL-3.0-or-later
"""PyMeshLab's own tests end as they do without our plugin when it is among PyMeshLab's plugins."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pymeshlab
import pytest

PACKAGE = Path(pymeshlab.__file__).resolve().parent
OWN_TESTS = sorted(
    path.name
    for pattern in ("test_*.py", "example_*.py")
    for path in (PACKAGE / "tests").glob(pattern)
)


def link_or_copy(source: str, destination: str) -> None:
    """Spare the 280 MB where temporary files lie on the same disk."""
    try:
        os.link(source, destination)
    except OSError:
        shutil.copy2(source, destination)


@pytest.fixture(scope="module")
def sites(tmp_path_factory: pytest.TempPathFactory, plugin: Path) -> tuple[Path, Path]:
    """Two folders with a pymeshlab: as it is, and with our plugin where --install puts it."""
    without = tmp_path_factory.mktemp("without")
    with_plugin = tmp_path_factory.mktemp("with")
    for site in (without, with_plugin):
        shutil.copytree(PACKAGE, site / "pymeshlab", copy_function=link_or_copy)
    shutil.copy(plugin, with_plugin / "pymeshlab" / "lib" / "plugins")
    return without, with_plugin


def outcome(site: Path, test: str) -> str:
    """Run one file of PyMeshLab's tests in a process of its own: some need a graphics card."""
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "-p",
        "no:faulthandler",
    ]
    run = subprocess.run(
        [*command, "-c", "pymeshlab/setup.cfg", f"pymeshlab/tests/{test}"],
        cwd=site,
        env=os.environ | {"PYTHONPATH": str(site), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    return {0: "passed", 1: "failed"}.get(run.returncode, f"ended with {run.returncode}")


def test_the_copies_are_as_they_should_be(sites: tuple[Path, Path]) -> None:
    ask = (
        "import pymeshlab; print(pymeshlab.__file__, "
        "hasattr(pymeshlab.MeshSet, 'generate_surface_reconstruction_neural_mesh'))"
    )
    for site, bound in zip(sites, ("False", "True"), strict=True):
        said = subprocess.run(
            [sys.executable, "-c", ask],
            cwd=site,
            env=os.environ | {"PYTHONPATH": str(site)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout.split()
        assert said == [str(site / "pymeshlab" / "__init__.py"), bound]


@pytest.mark.parametrize("test", OWN_TESTS)
def test_own_test_of_pymeshlab_ends_as_without_us(sites: tuple[Path, Path], test: str) -> None:
    if test == "test_number_plugins.py":
        pytest.skip("it counts the plugins, and ours is one more")
    without, with_plugin = sites
    assert outcome(with_plugin, test) == outcome(without, test)
