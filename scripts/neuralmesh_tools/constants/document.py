# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tables of docs/constants.md: what the source says, and what was measured."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.constants.catalogue import CATALOGUE
from neuralmesh_tools.constants.entries import Key
from neuralmesh_tools.constants.source import ATTRIBUTES, PARAMETERS, Constant, read_constants

DOCUMENT = Path("docs") / "constants.md"
UNKNOWN = "–"
# By title: where the constants are. A constant belongs to the first that fits.
LAYERS = {
    "learning": (PARAMETERS, "core/network/learning_rules.h"),
    "growth": ("core/growth.cpp", "core/space/point_spacing.h"),
    "network": ("core/network/",),
    "fit": ("core/fit/",),
    "result": ("core/result/", ATTRIBUTES),
    "samplers": ("samplers/",),
    "space": ("core/mesh/", "core/space/"),
    "topology": ("core/topology/",),
    "shape": ("core/shape/",),
}
# Those whose values another representation, or a file format, would change and nothing else.
_MARKS = re.compile(r"0xffffffffU|-1|std::numeric_limits<\w+>::infinity\(\)")
_FORMATS = (
    "las_header.cpp",
    "npy_header.cpp",
    "ply_header.cpp",
    "point_layout.cpp",
    "point_survey.cpp",
)


@dataclass(frozen=True)
class Measured:
    """Cells of a row, and the value that they were measured beside."""

    value: str
    half: str = UNKNOWN
    double: str = UNKNOWN


Figures = dict[Key, Measured]


def layer_of(constant: Constant) -> str:
    """Return the name of the table that has a constant."""
    if _MARKS.fullmatch(constant.value) or constant.file.endswith(_FORMATS):
        return "fixed"
    return next(
        (layer for layer, places in LAYERS.items() if constant.file.startswith(places)), "space"
    )


def rendered(text: str, root: Path, measured: Mapping[Key, Measured]) -> str:
    """Return the document with its tables made anew.

    Figures are taken from `measured`, else from the text where the value is still the same.
    """
    constants = read_constants(root)
    figures = figures_in(text) | dict(measured)
    for layer in [*LAYERS, "fixed"]:
        mine = [c for c in constants.values() if layer_of(c) == layer]
        table = _table(mine, figures, _has_sweep(mine))
        begin, end = f"<!-- table: {layer} -->", "<!-- end of table -->"
        pattern = re.compile(f"{re.escape(begin)}.*?{re.escape(end)}", re.DOTALL)
        if not pattern.search(text):
            raise ValueError(f"{DOCUMENT} has no place for the table {layer}")
        text = pattern.sub(lambda _, t=table, b=begin, e=end: f"{b}\n{t}\n{e}", text)
    return text


def figures_in(text: str) -> Figures:
    """Read what was measured out of the document's rows."""
    found: Figures = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        if line.startswith("| `") and len(cells) == 7:
            name, file, value = (cell.strip("`") for cell in cells[:3])
            found[_full(file), name] = Measured(value, cells[5], cells[6])
    return found


def rows_in(text: str) -> dict[Key, str]:
    """Read the values out of the document's rows, by file and name."""
    found: dict[Key, str] = {}
    for line in text.splitlines():
        cells = [cell.strip().strip("`") for cell in line.strip("|").split(" | ")]
        if line.startswith("| `") and len(cells) in (4, 7):
            found[_full(cells[1]), cells[0]] = cells[2]
    return found


def _full(file: str) -> str:
    return file if file.startswith(("samplers/", "include/")) else f"core/{file}"


def _has_sweep(constants: Iterable[Constant]) -> bool:
    return any(c.key in CATALOGUE and CATALOGUE[c.key].is_swept for c in constants)


def _table(constants: Iterable[Constant], figures: Figures, is_swept: bool) -> str:
    if is_swept:
        lines = [
            "| constant | in | value | unit | source | at half | at double |",
            "|---|---|---|---|---|---|---|",
        ]
    else:
        lines = ["| constant | in | value | what it is |", "|---|---|---|---|"]
    for constant in constants:
        comment = f"see `{constant.see}`" if constant.see else constant.comment
        if not comment and _MARKS.fullmatch(constant.value):
            comment = "stands for nothing"
        cells = [f"`{constant.name}`", f"`{constant.file.removeprefix('core/')}`"]
        cells += [f"`{constant.value}`", *_rest(constant, comment, figures, is_swept)]
        lines.append(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |")
    return "\n".join(lines)


def _rest(constant: Constant, comment: str, figures: Figures, is_swept: bool) -> list[str]:
    entry = CATALOGUE.get(constant.key)
    source = "; ".join(filter(None, [comment.rstrip("."), entry.source if entry else ""]))
    if not is_swept:
        return [f"{source} ({entry.unit})" if entry and entry.unit else source or UNKNOWN]
    if entry is None:
        return [UNKNOWN, source, "not swept", "not swept"]
    if not entry.is_swept:
        return [entry.unit, source, "not swept", "not swept"]
    measured = figures.get(constant.key, Measured(constant.value))
    if measured.value != constant.value:
        measured = Measured(constant.value)
    return [entry.unit, source, measured.half, measured.double]
