# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/sweep_constants.py."""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from neuralmesh_tools.changed_build import BuildFailed, Stale
from neuralmesh_tools.command_line import parser_of
from neuralmesh_tools.constants.catalogue import CATALOGUE
from neuralmesh_tools.constants.document import DOCUMENT, Measured, layer_of, rendered
from neuralmesh_tools.constants.entries import Key
from neuralmesh_tools.constants.measure import NotMeasured, Task
from neuralmesh_tools.constants.source import Constant, read_constants
from neuralmesh_tools.constants.sweep import Sweep
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.project import ROOT

FIGURES = ROOT / "out" / "constants" / "figures.json"
NICE = 10


def _arguments(description: str | None, arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = parser_of(description)
    parser.add_argument("--list", action="store_true", help="only say what there is to sweep")
    parser.add_argument(
        "--only",
        action="append",
        default=[],
        metavar="NAME",
        help="constants of this name, file or layer (may be repeated)",
    )
    parser.add_argument("--values", metavar="A,B,...", help="instead of half and double")
    parser.add_argument("--chance", action="store_true", help="only what other seeds change")
    parser.add_argument(
        "--document", action="store_true", help=f"only write the tables of {DOCUMENT}"
    )
    default = Task()
    parser.add_argument("--vertices", type=int, default=default.vertices, metavar="N")
    parser.add_argument(
        "--seeds", type=int, default=len(default.seeds), metavar="N", help="how many (default 3)"
    )
    options = parser.parse_args(arguments)
    if options.vertices < 4 or options.seeds < 1:
        parser.error("--vertices must be at least 4, --seeds at least 1")
    return options


def _selected(names: Sequence[str]) -> list[Constant]:
    """The constants that are swept, of these names, files and layers; raises Stale."""
    there = read_constants(ROOT)
    if gone := [name for file, name in CATALOGUE if (file, name) not in there]:
        raise Stale(f"The catalogue names what is not in the source: {', '.join(gone)}.")
    swept = [c for key, c in there.items() if key in CATALOGUE and CATALOGUE[key].is_swept]
    for name in names:
        if not any(_fits(constant, [name]) for constant in swept):
            raise Stale(f"There is no constant, file or layer {name} that is swept.")
    return [c for c in swept if not names or _fits(c, names)]


def _fits(constant: Constant, names: Sequence[str]) -> bool:
    return any(name in (constant.name, constant.file, layer_of(constant)) for name in names)


def _kept() -> dict[Key, Measured]:
    if not FIGURES.is_file():
        return {}
    stored = json.loads(FIGURES.read_text(encoding="utf-8"))
    return {(file, name): Measured(*cells) for file, name, *cells in stored}


def _keep(constant: Constant, cells: Sequence[str]) -> None:
    figures = _kept() | {constant.key: Measured(constant.value, *cells)}
    rows = [[*key, m.value, m.half, m.double] for key, m in figures.items()]
    write_in_one_step(FIGURES, json.dumps(rows, indent=0, ensure_ascii=False) + "\n")


def _write_document() -> int:
    path = ROOT / DOCUMENT
    write_in_one_step(path, rendered(path.read_text(encoding="utf-8"), ROOT, _kept()))
    print(f"{DOCUMENT} is written.")
    return 0


def _sweep(
    constants: Sequence[Constant], sweep: Sweep, values: Sequence[str], is_kept: bool
) -> int:
    failed = 0
    for constant in constants:
        entry = CATALOGUE[constant.key]
        cells = []
        for outcome in sweep.measure(constant, values or (entry.half, entry.double)):
            print(f"{constant.name} {constant.value} -> {outcome.value}: {outcome}", flush=True)
            cells.append(f"`{outcome.value}`: {outcome}")
            failed += outcome.effect is None
        if is_kept:
            _keep(constant, cells)
    return 1 if failed else 0


def main(description: str | None, arguments: Sequence[str] | None = None) -> int:
    """Run the command and return its exit code."""
    options = _arguments(description, arguments)
    task = Task(options.vertices, tuple(range(1, options.seeds + 1)))
    try:
        if options.document:
            return _write_document()
        constants = _selected(options.only)
        if options.list:
            for constant in constants:
                entry = CATALOGUE[constant.key]
                print(f"{constant.file}: {constant.name} = {constant.value} ({entry.unit})")
                print(f"    {entry.half}, {entry.double}: {', '.join(entry.shapes)}")
            return 0
        os.nice(NICE)
        with tempfile.TemporaryDirectory(prefix="neuralmesh-constants-") as scratch:
            sweep = Sweep(ROOT, task, Path(scratch))
            if not options.chance:
                values = options.values.split(",") if options.values else []
                return _sweep(constants, sweep, values, task == Task() and not values)
            for group, effects in sweep.chance():
                print(f"{group}: {effects}", flush=True)
        return 0
    except (BuildFailed, NotMeasured, Stale) as error:
        print(error, file=sys.stderr)
        return 2
