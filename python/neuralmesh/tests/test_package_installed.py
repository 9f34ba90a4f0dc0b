# SPDX-License-Identifier: GPL-3.0-or-later
"""The built wheel in a new virtual environment, without PyMeshLab, Qt or libGL."""

from __future__ import annotations

import re
import subprocess
import sys
import zipfile
from email import message_from_string
from pathlib import Path

import neuralmesh
import numpy as np
import pytest
from numpy.typing import NDArray

from neuralmesh_tools.project import ROOT
from neuralmesh_tools.release import needs
from neuralmesh_tools.release.check import NOTICES

SCRIPT = """
import neuralmesh, numpy as np
points = np.load("bunny.npy")
result = neuralmesh.reconstruct(points, vertices=5000)
np.savez("script.npz", vertices=result.vertices, faces=result.faces)
print(result)
"""


@pytest.fixture(scope="module")
def wheel() -> Path:
    found = list((ROOT / "build/python/wheel").glob("neuralmesh-*.whl"))
    if len(found) != 1:
        pytest.fail("the wheel is missing: run scripts/build python", pytrace=False)
    return found[0]


def run(*command: object, folder: Path) -> str:
    done = subprocess.run(
        [*map(str, command)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_a_new_environment_makes_the_filters_mesh(
    wheel: Path, bunny: NDArray[np.float64], tmp_path: Path
) -> None:
    run(sys.executable, "-m", "venv", "env", folder=tmp_path)
    python = tmp_path / "env/bin/python"
    run(python, "-m", "pip", "install", "-q", "--disable-pip-version-check", wheel, folder=tmp_path)
    packages = run(python, "-m", "pip", "list", "--format=freeze", folder=tmp_path).lower()
    assert "neuralmesh" in packages
    assert not re.search(r"pymeshlab|pyqt|pyside|vtk|opengl", packages)

    np.save(tmp_path / "bunny.npy", bunny)
    command = neuralmesh.Mesh(bunny, np.zeros((0, 3), np.int32))
    neuralmesh.write(tmp_path / "bunny.ply", command)
    neuralmesh_ = tmp_path / "env/bin/neuralmesh"
    assert run(neuralmesh_, "bunny.ply", "-n", 5000, "-o", "out.ply", folder=tmp_path)
    assert run(python, "-c", SCRIPT, folder=tmp_path) == ("Result(5000 vertices, 9996 faces)\n")
    # test_package_equals_filter.py shows that the filter makes the same.
    expected = neuralmesh.reconstruct(bunny)
    made = np.load(tmp_path / "script.npz")
    assert np.array_equal(made["vertices"], expected.vertices)
    assert np.array_equal(made["faces"], expected.faces)
    assert np.array_equal(neuralmesh.read(tmp_path / "out.ply").points, expected.vertices)

    # Batches need no more than the wheel brings; comparisons say what they need.
    run(neuralmesh_, "batch", "bunny.ply", "--out", "batch", "-n", 5000, folder=tmp_path)
    assert np.array_equal(neuralmesh.read(tmp_path / "batch/bunny.ply").points, expected.vertices)
    refused = subprocess.run(
        [neuralmesh_, "compare", "bunny.ply", "--out", "report"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert refused.returncode == 2
    assert "needs pymeshlab, scipy, jinja2, plotly: pip install" in refused.stderr


def test_the_module_needs_no_library_but_those_of_cpp() -> None:
    module = Path(neuralmesh._core.__file__)
    assert needs.superfluous(module) == set()
    assert needs.search_path(module) == set()


def test_the_wheel_says_what_it_is(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        (place,) = (name for name in names if name.endswith(".dist-info/METADATA"))
        metadata = message_from_string(archive.read(place).decode("utf-8"))
    assert "neuralmesh/py.typed" in names
    assert "neuralmesh/_core.pyi" in names
    assert set(NOTICES) <= {Path(name).name for name in names}
    assert metadata["Name"] == "neuralmesh"
    assert metadata["Version"] == neuralmesh.__version__
    assert metadata["License-Expression"] == "GPL-3.0-or-later"
    assert "Topic :: Scientific/Engineering" in (metadata.get_all("Classifier") or [])
    assert "pip install" in metadata.get_payload()
    needs = metadata.get_all("Requires-Dist") or []
    assert [need for need in needs if "pymeshlab" in need] == [
        'pymeshlab>=2025.7; extra == "compare"'
    ]


def test_the_version_is_that_of_the_project() -> None:
    text = (ROOT / "pyproject.toml").read_text("utf-8")
    assert f'version = "{neuralmesh.__version__}"' in text
    package = (ROOT / "python/neuralmesh/pyproject.toml").read_text("utf-8")
    assert f'version = "{neuralmesh.__version__}"' in package
