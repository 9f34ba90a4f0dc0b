# SPDX-License-Identifier: GPL-3.0-or-later
"""pymeshlab_neuralmesh takes what people pass, and says what is wrong with what it cannot take."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from neuralmesh_tools.project import PLUGIN_NAME, ROOT

# Each line is run; what it raises, or a figure of what it returns, is printed.
PROGRAM = """
import json, sys
from pathlib import Path
import numpy as np
import pymeshlab
import pymeshlab_neuralmesh as nm

points = np.random.default_rng(0).normal(size=(300, 3))
points /= np.linalg.norm(points, axis=1)[:, None]
np.save("scan.npy", points)

def run(**parameters):
    document = nm.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(points), "scan")
    try:
        result = document.generate_surface_reconstruction_neural_mesh(**parameters)
        return [result["vertices"], document.mesh_number()]
    except TypeError as problem:
        return str(problem)

def apply(**parameters):
    document = nm.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(points), "scan")
    name = "generate_surface_reconstruction_neural_mesh"
    try:
        return document.apply_filter(name, **parameters)["vertices"]
    except TypeError as problem:
        return str(problem)

def created(**parameters):
    document = nm.MeshSet(verbose=False)
    document.apply_filter("create_sphere", **parameters)
    return document.current_mesh().vertex_number()

print(json.dumps([eval(line) for line in sys.stdin]))
"""
NAME = "generate_surface_reconstruction_neural_mesh()"
CASES = {
    "run(targetvertnum=50.0)": [50, 2],
    "run(targetvertnum=np.float32(50))": [50, 2],
    "run(TargetVertNum=50)": [50, 2],
    "run(targetvertnum=50, snapshots=[20, 30.0])": [50, 4],
    "run(targetvertnum=50, snapshots=np.array([20, 30]))": [50, 4],
    "run(targetvertnum=50, snapshots=20)": [50, 3],
    "run(targetvertnum=50, snapshots='20,30')": [50, 4],
    "run(targetvertnum=50, pointfile=Path('scan.npy'))": [50, 2],
    "run(targetvertnum=50, pointfile='scan.npy', source='A point file on disk')": [50, 2],
    "run(targetvertnum=50, maxholesize='5%')": [50, 2],
    "run(targetvertnum=50, maxholesize=1)": [50, 2],
    "run(targetvertnum=50, maxholesize=pymeshlab.PercentageValue(5))": [50, 2],
    "run(targetvertnum=50, surfacefit=np.bool_(False), topology=0, winnerrate=0.1)": [50, 2],
    "bool(nm.__version__)": True,
    "run(targetvertnum=50.5)": "targetvertnum is a whole number, not 50.5.",
    "run(targetvertnum=float('nan'))": "targetvertnum is a whole number, not nan.",
    "run(targetvertnum='many')": "targetvertnum is a whole number, not 'many'.",
    "run(targetvertnum=True)": "targetvertnum is a whole number, not True.",
    "run(snapshots=[20.5])": "snapshots is a whole number, not 20.5.",
    "run(surfacefit='yes')": "surfacefit is True or False, not 'yes'.",
    "run(winnerrate='fast')": "winnerrate is a number, not 'fast'.",
    "run(topology='Learnt')": "topology is one of That of the starting mesh, Learned from the "
    "data, not 'Learnt'.",
    "run(maxholesize='big')": 'maxholesize is a length, or a text such as "5%" of the diagonal, '
    "not 'big'.",
    "run(target_vert_num=50)": f"{NAME} has no parameter target_vert_num. Is it targetvertnum?",
    "run(vertices=50)": f"{NAME} has no parameter vertices. It has: ",
    "run(targetvertnum=50, TargetVertNum=50)": f"{NAME} got targetvertnum twice.",
    "apply(TargetVertNum=50.0, snapshots=[20], maxholesize='5%')": 50,
    "apply(target_vert_num=50)": f"{NAME} has no parameter target_vert_num. Is it targetvertnum?",
    "created(subdiv=1)": 42,  # PyMeshLab's own filters are as they were
}


# PyMeshLab alone crashes on it: see docs/install.md.
FAILURES = """
import sys
import pymeshlab_neuralmesh as nm

for _ in range(3):
    for kwargs in ({"targetvertnum": 2}, {"targetvertnum": 50, "winnerrate": 2}):
        document = nm.MeshSet(verbose=False)
        document.load_new_mesh(sys.argv[1])
        try:
            document.apply_filter("generate_surface_reconstruction_neural_mesh", **kwargs)
        except Exception as problem:
            print(type(problem).__name__)
        del document
"""


@pytest.fixture(scope="module")
def package(plugin: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the package put together as the wheel has it."""
    folder = tmp_path_factory.mktemp("wrapper")
    shutil.copytree(ROOT / "python", folder / "python")
    (folder / "python/pymeshlab_neuralmesh" / PLUGIN_NAME).symlink_to(plugin)
    return folder


def run_python(package: Path, *arguments: object, text: str = "") -> str:
    """What a program prints that has the package; a process of its own, which may crash."""
    run = subprocess.run(
        [sys.executable, "-c", *map(str, arguments)],
        input=text,
        cwd=package,
        env=os.environ | {"PYTHONPATH": str(package / "python")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


@pytest.fixture(scope="module")
def results(package: Path) -> dict[str, object]:
    """What each case gives."""
    printed = run_python(package, PROGRAM, text="\n".join(CASES))
    return dict(zip(CASES, json.loads(printed.splitlines()[-1]), strict=True))


@pytest.mark.parametrize("case", CASES)
def test_what_people_pass_is_taken_or_named(results: dict[str, object], case: str) -> None:
    expected = CASES[case]
    if isinstance(expected, str) and expected.endswith(" "):
        assert str(results[case]).startswith(expected)
    else:
        assert results[case] == expected


def test_documents_can_be_loaded_after_a_filter_has_raised(
    package: Path, sample_meshes: Path
) -> None:
    printed = run_python(package, FAILURES, sample_meshes / "bunny.obj")
    assert printed.split() == ["PyMeshLabException"] * 6
