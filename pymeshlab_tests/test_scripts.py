# SPDX-License-Identifier: GPL-3.0-or-later
"""What is in scripts/ can be run from any folder and says what it does; what its parts share."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from neuralmesh_tools.files import sha256_of, write_in_one_step
from neuralmesh_tools.project import SCRIPTS, PluginMissing, require_plugin

PROGRAMS = sorted(path for path in SCRIPTS.iterdir() if path.is_file())


def test_each_file_is_a_program():
    assert len(PROGRAMS) >= 11
    assert [path.name for path in PROGRAMS if not os.access(path, os.X_OK)] == []


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.name)
def test_each_program_explains_itself_from_any_folder(program: Path, tmp_path: Path):
    venv = {"PATH": f"{SCRIPTS.parent / '.venv' / 'bin'}:{os.environ['PATH']}"}
    run = subprocess.run(
        [program, "--help"],
        cwd=tmp_path,
        env=os.environ | venv,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    assert "usage: " in run.stdout.lower()
    assert list(tmp_path.iterdir()) == []


def test_a_file_is_written_whole_and_nothing_is_left_beside_it(tmp_path: Path):
    path = tmp_path / "deep" / "file"
    write_in_one_step(path, "größer\n")
    assert path.read_bytes() == "größer\n".encode()
    write_in_one_step(path, b"\x00\xff")
    assert path.read_bytes() == b"\x00\xff"
    assert list(path.parent.iterdir()) == [path]
    # SHA-256 of these two bytes, by sha256sum.
    assert sha256_of(path) == "06eb7d6a69ee19e5fbdf749018d3d2abfa04bcbd1365db312eb86dc7169389b8"


def test_a_plugin_that_is_not_there_is_a_sentence(tmp_path: Path):
    with pytest.raises(PluginMissing, match=r"The plugin .*none\.so is not there: run scripts/b"):
        require_plugin(tmp_path / "none.so")
