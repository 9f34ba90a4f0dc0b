# SPDX-License-Identifier: GPL-3.0-or-later
"""Each constant has its row in docs/constants.md, and what sweeps them compares what it says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from neuralmesh_tools.changed_build import changed_text
from neuralmesh_tools.constants.catalogue import CATALOGUE
from neuralmesh_tools.constants.command_line import main
from neuralmesh_tools.constants.document import DOCUMENT, Measured, rendered, rows_in
from neuralmesh_tools.constants.measure import Figures, NotMeasured, Task, compare
from neuralmesh_tools.constants.source import Constant, constants_in, read_constants
from neuralmesh_tools.constants.tunable import is_tunable, with_variables
from neuralmesh_tools.project import ROOT

TEXT = (ROOT / DOCUMENT).read_text("utf-8")
CONSTANTS = read_constants(ROOT)
SWEPT = [CONSTANTS[key] for key, entry in CATALOGUE.items() if entry.is_swept and key in CONSTANTS]
# Of namespace scope and no numbers: an order of bytes, words, and tables of cases.
NO_NUMBERS = {
    "hostIsBigEndian",
    "magic",
    "compressorName",
    "typeSizes",
    "extents",
    "tetrahedra",
    "alone",
    "paired",
}
WRITE = "scripts/sweep_constants.py --document writes the tables again"

# ------------------------------------------------------------------------------- the document


def test_each_constant_has_a_row_with_its_value_and_each_row_a_constant() -> None:
    values = {constant.key: constant.value for constant in CONSTANTS.values()}
    assert rows_in(TEXT) == values, WRITE


def test_the_tables_say_what_source_and_catalogue_say() -> None:
    assert rendered(TEXT, ROOT, {}) == TEXT, WRITE


def test_no_constant_of_namespace_scope_is_overlooked() -> None:
    # Read in another way than the tables are.
    pattern = re.compile(r"^(?:inline )?constexpr [\w:]+ (\w+)(?:\[.*\])? = ", re.MULTILINE)
    there = {
        (path.relative_to(ROOT / "filter_neuralmesh").as_posix(), name)
        for folder in ("core", "samplers")
        for path in (ROOT / "filter_neuralmesh" / folder).rglob("*")
        if path.is_file()
        for name in pattern.findall(path.read_text("utf-8"))
        if name not in NO_NUMBERS
    }
    assert len(there) > 100
    assert there <= set(CONSTANTS)


def test_what_is_swept_has_figures_of_half_and_double() -> None:
    for constant in SWEPT:
        row = next(
            line
            for line in TEXT.splitlines()
            if line.startswith(f"| `{constant.name}` | `{constant.file.removeprefix('core/')}` |")
        )
        half, double = row.strip("|").split(" | ")[-2:]
        entry = CATALOGUE[constant.key]
        assert half.strip().startswith(f"`{entry.half}`: "), constant.name
        assert double.strip().startswith(f"`{entry.double}`: "), constant.name


def test_figures_go_where_the_value_is_another_one() -> None:
    constant = SWEPT[0]
    measured = {constant.key: Measured(constant.value, "HALF", "DOUBLE")}
    assert "| HALF | DOUBLE |" in rendered(TEXT, ROOT, measured)
    measured = {constant.key: Measured("12345", "HALF", "DOUBLE")}
    assert "HALF" not in rendered(TEXT, ROOT, measured)


# ------------------------------------------------------------------------------ the catalogue


def test_the_catalogue_names_what_is_in_the_source() -> None:
    assert [key for key in CATALOGUE if key not in CONSTANTS] == []


@pytest.mark.parametrize("constant", SWEPT, ids=lambda c: f"{Path(c.file).stem}-{c.name}")
def test_each_change_of_a_sweep_applies_to_the_source(constant: Constant) -> None:
    entry = CATALOGUE[constant.key]
    assert len({constant.value, entry.half, entry.double}) == 3
    for value in (entry.half, entry.double):
        text = changed_text(
            ROOT, constant.path, constant.text, constant.text_with(value), constant.name
        )
        changed = {c.key: c.value for c in constants_in(constant.file, text)}
        before = {key: c.value for key, c in CONSTANTS.items() if key[0] == constant.file}
        assert changed == before | {constant.key: value}


def test_each_shape_of_a_sweep_is_one_that_is_measured() -> None:
    source = (ROOT / "filter_neuralmesh/bench/measured_shapes.cpp").read_text("utf-8")
    list_of_shapes = source.split("shapes{")[1].split("};")[0]
    there = set(re.findall(r'"([\w.-]+)"', list_of_shapes))
    assert {shape for entry in CATALOGUE.values() for shape in entry.shapes} <= there


# --------------------------------------------------------------------------- reading the source

SOURCE = """
/// Of two: length, in edges.
constexpr double length = 0.5;
constexpr Scalar steps[] = {1, 2,
                            3};

inline constexpr int count = 8; ///< vertices
constexpr char word[] = "text";
constexpr int twice(int x)
{
    constexpr int local = 2;
    static constexpr int other = 3;
    return local * x;
}

class Grid {
public:
    static constexpr int cells = 4;

private:
    static constexpr unsigned none = 0xffffffffU;
};
"""


def test_constants_are_read_with_their_comments_and_without_those_of_functions() -> None:
    found = {c.name: c for c in constants_in("core/grid.h", SOURCE)}
    assert {name: c.value for name, c in found.items()} == {
        "length": "0.5",
        "steps": "{1, 2, 3}",
        "count": "8",
        "cells": "4",
        "none": "0xffffffffU",
    }
    assert found["length"].comment == "Of two: length, in edges."
    assert (found["steps"].see, found["count"].see) == ("length", "")
    assert found["count"].comment == "vertices"
    assert found["steps"].text_with("{4}") == "steps[] = {4};"


def test_plain_numbers_of_source_files_become_variables() -> None:
    found = {c.name: c for c in constants_in("core/grid.cpp", SOURCE)}
    assert is_tunable(found["length"], ["0.25", "1e-3"])
    assert not is_tunable(found["length"], ["1 << 2"])
    assert not is_tunable(found["steps"], ["{1}"])
    assert not is_tunable(next(constants_in("core/grid.h", SOURCE)), ["1"])
    text = with_variables(SOURCE, [found["length"]])
    assert text.endswith(
        SOURCE.replace(
            "constexpr double length = 0.5;",
            'const double length = static_cast<double>(valueFromEnvironment("length", 0.5));',
        )
    )


# ---------------------------------------------------------------------------------- comparing


def figures(shape: str, seed: int, rms: float, crossings: int = 0) -> Figures:
    return Figures(shape, seed, rms, 10 * rms, 70, 1, crossings)


BEFORE = [figures("hand", seed, 1) for seed in (1, 2, 3)] + [
    figures("plate", seed, 2) for seed in (1, 2, 3)
]


def test_a_ratio_is_of_the_medians_of_seeds_in_the_mean_of_shapes() -> None:
    after = [figures("hand", seed, rms) for seed, rms in ((1, 1), (2, 4), (3, 90))] + [
        figures("plate", seed, 2, crossings=5) for seed in (1, 2, 3)
    ]
    effect = compare(BEFORE, after)
    assert effect.rms == pytest.approx(2)  # the root of 4 and 1
    assert (effect.furthest, effect.furthest_rms) == ("hand", 4)
    assert str(effect) == "2.00 (hand 4.00) / 2.00 / 1.00 / 1.00 / +15"


def test_the_same_meshes_are_told_from_like_ones() -> None:
    assert str(compare(BEFORE, BEFORE)) == "the same meshes"
    like = [*BEFORE[:-1], figures("plate", 3, 2.000001)]
    assert str(compare(BEFORE, like)) == "1.00 / 1.00 / 1.00 / 1.00"


def program(folder: Path, text: str) -> Path:
    path = folder / "program"
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


def test_a_program_that_fails_or_does_not_end_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("neuralmesh_tools.constants.measure.TIMEOUT", 0.5)
    with pytest.raises(NotMeasured, match="too small"):
        Task().run(program(tmp_path, "echo too small >&2; exit 1"), ["hand"])
    with pytest.raises(NotMeasured, match="no end after"):
        Task().run(program(tmp_path, "exec sleep 60"), ["hand"])


def test_the_program_finds_values_in_its_environment(tmp_path: Path) -> None:
    row = "hand\\t1\\t$length\\t2\\t71\\t0.25\\t3"
    path = program(tmp_path, f'printf "head\\n{row}\\n"')
    assert Task().run(path, ["hand"], environment={"length": "0.75"})[0].rms == 0.75


def test_rows_of_the_program_are_read(tmp_path: Path) -> None:
    row = "hand\\t1\\t0.5\\t2\\t71\\t0.25\\t3"
    found = Task().run(program(tmp_path, f"printf 'head\\n{row}\\n'"), ["hand"])
    assert found == [Figures("hand", 1, 0.5, 2, 71, 0.25, 3)]


# ------------------------------------------------------------------------------ the command line


def test_an_unknown_constant_is_a_sentence_and_exit_code_2(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(None, ["--only", "nonsense"]) == 2
    assert "There is no constant, file or layer nonsense" in capsys.readouterr().err


def test_the_list_names_all_that_is_swept(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(None, ["--list"]) == 0
    printed = capsys.readouterr().out
    for constant in SWEPT:
        assert f"{constant.file}: {constant.name} = {constant.value}" in printed
