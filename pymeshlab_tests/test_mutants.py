# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants fit the source as it is, and so does what is said of them.

Whether their tests notice them is for scripts/test --mutants to find out, which builds them.
"""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path

import pytest

from neuralmesh_tools.changed_build import BuildFailed, BuiltProgram, Stale
from neuralmesh_tools.mutants.catalogue import MUTANTS
from neuralmesh_tools.mutants.command_line import Unusable, main, selected
from neuralmesh_tools.mutants.mutant import FOLDER, Mutant
from neuralmesh_tools.mutants.run import failing_tests
from neuralmesh_tools.project import ROOT

MUTANT = Mutant("no-step", "takes the step", "core/walk.cpp", "step();", "", ("Walk.arrives",))


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_each_mutant_applies_to_the_source(mutant: Mutant) -> None:
    assert mutant.applied(ROOT) != (ROOT / mutant.path).read_text(encoding="utf-8")


def test_each_mutant_has_a_name_of_its_own_and_tests_that_there_are() -> None:
    assert len({mutant.name for mutant in MUTANTS}) == len(MUTANTS)
    there = {
        f"{suite}.{name}"
        for file in (ROOT / FOLDER / "tests").rglob("*.cpp")
        for suite, name in re.findall(r"\bTEST(?:_F)?\(\s*(\w+),\s*(\w+)\)", file.read_text())
    }
    for mutant in MUTANTS:
        assert mutant.tests, mutant.name
        assert set(mutant.tests) <= there, mutant.name


def write_source(root: Path, text: str) -> None:
    (root / MUTANT.path).parent.mkdir(parents=True)
    (root / MUTANT.path).write_text(text)


def test_a_mutant_changes_its_text_only(tmp_path: Path) -> None:
    write_source(tmp_path, "look();\nstep();\n")
    assert MUTANT.applied(tmp_path) == "look();\n\n"


@pytest.mark.parametrize("source", ["", "step();\nstep();\n"])
def test_a_mutant_whose_text_is_not_there_exactly_once_is_stale(
    source: str, tmp_path: Path
) -> None:
    write_source(tmp_path, source)
    with pytest.raises(Stale, match=r"no-step: .*walk.cpp holds its text [02] times, not once"):
        MUTANT.applied(tmp_path)


def test_a_mutant_whose_file_has_moved_is_stale(tmp_path: Path) -> None:
    with pytest.raises(Stale, match=r"no-step: there is no .*walk.cpp"):
        MUTANT.applied(tmp_path)


def test_parts_make_up_the_whole() -> None:
    mutants = [dataclasses.replace(MUTANT, name=str(number)) for number in range(10)]
    parts = [selected(mutants, [], f"{part}/3") for part in (1, 2, 3)]
    assert sorted(int(m.name) for part in parts for m in part) == list(range(10))
    assert max(map(len, parts)) - min(map(len, parts)) <= 1
    assert selected(mutants, ["7", "2"], None) == [mutants[7], mutants[2]]


@pytest.mark.parametrize("part", ["0/3", "4/3", "1", "x/y"])
def test_a_part_that_there_is_not_is_a_sentence(part: str) -> None:
    with pytest.raises(Unusable, match="--part takes K/N"):
        selected(MUTANTS, [], part)


def test_an_unknown_mutant_is_a_sentence_and_exit_code_2(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["--only", "nonsense"]) == 2
    assert "There is no mutant nonsense; there are: " in capsys.readouterr().err


def test_the_list_names_each_with_its_tests(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--list"]) == 0
    printed = capsys.readouterr().out
    for mutant in MUTANTS:
        assert f"{mutant.name}: {mutant.switches_off}" in printed
        assert ", ".join(mutant.tests) in printed


def test_a_folder_without_a_build_is_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(BuildFailed, match="holds no build: run scripts/build release"):
        BuiltProgram(tmp_path, tmp_path)


END = "echo '[==========] 2 tests from 1 test suite ran. (1 ms total)'"
FAKE_TESTS = """#!/bin/sh
echo '[==========] Running 2 tests from 1 test suite.'
echo '[ RUN      ] Walk.starts'
echo '[       OK ] Walk.starts (0 ms)'
echo '[ RUN      ] Walk.arrives'
"""


@pytest.mark.parametrize(
    ("ending", "failing"),
    [
        (f"echo '[  FAILED  ] Walk.arrives (1 ms)'; {END}; exit 1", ("Walk.arrives",)),
        ("kill -SEGV $$", ("Walk.arrives",)),
        ("exec sleep 60", ("Walk.arrives",)),
        (f"echo '[       OK ] Walk.arrives (1 ms)'; {END}", ()),
    ],
    ids=["fails", "crashes", "hangs", "passes"],
)
def test_a_test_that_fails_crashes_or_hangs_has_noticed(
    ending: str, failing: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("neuralmesh_tools.mutants.run.TIMEOUT", 2.0)
    tests = tmp_path / "tests"
    tests.write_text(FAKE_TESTS + ending + "\n")
    tests.chmod(0o755)
    assert failing_tests(tests) == failing
