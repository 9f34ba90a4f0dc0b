# SPDX-License-Identifier: GPL-3.0-or-later
"""The README says what is so: its Python runs as printed, its tables list what there is."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from documents import FILTER, IMPLICIT, PARAMETRIC, document_of, reconstruct, sphere_points

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
SNIPPETS = re.findall(r"^```python\n(.*?)^```$", README, flags=re.MULTILINE | re.DOTALL)


BATCHES = re.findall(r"^(\S+ scripts/batch\.py (?:(?!--scheduler).)*)$", README, flags=re.MULTILINE)


def section(title: str) -> str:
    """Return the text between a heading and the next one."""
    found = re.search(rf"^#+ {re.escape(title)}\n(.*?)(?=^#|\Z)", README, re.MULTILINE | re.DOTALL)
    assert found, f"README.md has no section '{title}'"
    return found.group(1)


def table_rows(text: str) -> list[list[str]]:
    """Return the cells of a table's rows, without its head."""
    lines = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def test_there_is_a_python_snippet() -> None:
    assert SNIPPETS


@pytest.mark.parametrize("code", SNIPPETS)
def test_python_snippet_runs_as_printed(code: str, plugin: Path, tmp_path: Path) -> None:
    # In a folder of its own that shows the build, as the project's root does.
    (tmp_path / "build").symlink_to(plugin.parent.parent, target_is_directory=True)
    # And with the Python package, put together as the wheel has it.
    shutil.copytree(ROOT / "python", tmp_path / "python")
    (tmp_path / "python/pymeshlab_neuralmesh/libfilter_neuralmesh.so").symlink_to(plugin)
    run = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(tmp_path / "python")},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    if code == SNIPPETS[0]:
        promised = re.search(r"It prints `(.*?)`", README)
        assert promised
        assert promised.group(1) in run.stdout.splitlines()
    saved = re.findall(r'save_current_mesh\("(.*?)"\)', code)
    assert saved
    for name in saved:
        assert (tmp_path / name).stat().st_size > 0


def defaults_of(filter_name: str) -> dict[str, str]:
    """Return a filter's parameters and their defaults as the README prints them."""
    # As many points as it takes for the general default of the target.
    actual = document_of(sphere_points(10_000)).filter_parameter_values(filter_name)
    return {
        name: f"{value:.6g}" if isinstance(value, float) else str(value)
        for name, value in actual.items()
    }


@pytest.mark.parametrize("command", BATCHES)
def test_batch_runs_as_printed(command: str, plugin: Path, tmp_path: Path) -> None:
    for name in (".venv", "build", "scripts"):
        (tmp_path / name).symlink_to(ROOT / name, target_is_directory=True)
    run = subprocess.run(
        ["bash", "-c", command],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert len(list((tmp_path / "out" / "batch").glob("*.ply"))) == 4


def test_there_is_a_batch() -> None:
    assert len(BATCHES) == 1


def test_parameter_table_lists_all_parameters_with_their_defaults(plugin: Path) -> None:
    printed = {row[0].strip("`"): row[1] for row in table_rows(section("Parameters"))}
    assert printed == defaults_of(FILTER)


OF_LAYERS_ONLY = {"source", "pointfile", "densityfromquality", "transferattributes"}


@pytest.mark.parametrize(
    ("filter_name", "words"),
    [(IMPLICIT, "Of an implicit surface:"), (PARAMETRIC, "Of a parametric surface:")],
)
def test_tables_of_the_other_filters_list_what_they_have_of_their_own(
    filter_name: str, words: str, plugin: Path
) -> None:
    text = section("Parameters of the other two filters").split(words)[1].split("\nOf a")[0]
    printed = {row[0].strip("`"): row[1] for row in table_rows(text)}
    shown = defaults_of(filter_name)
    for common in set(defaults_of(FILTER)) - OF_LAYERS_ONLY:
        del shown[common]
    assert printed == shown


def test_table_of_results_lists_all_keys(plugin: Path) -> None:
    printed = [
        key
        for row in table_rows(section("What it returns"))
        for key in re.findall(r"`(.*?)`", row[0])
    ]
    result = reconstruct(document_of(sphere_points(50)), targetvertnum=10)
    assert sorted(printed) == sorted(result)


@pytest.mark.parametrize("target", re.findall(r"\]\(([^)]+)\)", README))
def test_links_lead_to_files(target: str) -> None:
    assert (ROOT / target).is_file()
