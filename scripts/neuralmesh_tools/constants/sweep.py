# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what becomes of meshes with other values of a constant."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from neuralmesh_tools.changed_build import BuildFailed, BuiltProgram, changed_text
from neuralmesh_tools.constants.catalogue import CATALOGUE
from neuralmesh_tools.constants.entries import BODIES, EDGES, SCANS, WALLS
from neuralmesh_tools.constants.measure import (
    PROGRAM,
    Effect,
    Figures,
    NotMeasured,
    Task,
    compare,
)
from neuralmesh_tools.constants.source import PARAMETERS, Constant, read_constants
from neuralmesh_tools.constants.tunable import is_tunable, with_variables

GROUPS = {"bodies": BODIES, "walls": WALLS, "edges": EDGES, "scans": SCANS}


@dataclass(frozen=True)
class Outcome:
    """Of one value of a constant."""

    constant: Constant
    value: str
    effect: Effect | None
    problem: str = ""
    """Why there is no effect."""

    def __str__(self) -> str:
        """The effect, or the problem."""
        return str(self.effect) if self.effect else self.problem


class Sweep:
    """The measuring program, built as it is and with changes, in a scratch folder."""

    def __init__(self, root: Path, task: Task, scratch: Path) -> None:
        """Bring the build in build/release up to date. Raises BuildFailed."""
        self._root = root
        self._task = task
        self._scratch = scratch
        self._build = BuiltProgram(root, root / "build" / "release", PROGRAM)
        self._before: list[Figures] = []
        self._measured: tuple[Path, str, tuple[str, ...]] | None = None
        self._tunable: dict[str, Path | None] = {}

    def measure(self, constant: Constant, values: Sequence[str]) -> Iterator[Outcome]:
        """Yield what becomes of the constant's shapes with each value."""
        shapes = CATALOGUE[constant.key].shapes
        tunable = self._with_variables(constant) if is_tunable(constant, values) else None
        program = tunable or self._build.executable
        # Anew for each file: times depend on what else the machine does.
        if self._measured != (program, constant.file, shapes):
            self._before = self._task.run(program, shapes)
            self._measured = (program, constant.file, shapes)
        for value in values:
            try:
                if tunable:
                    after = self._task.run(tunable, shapes, environment={constant.name: value})
                else:
                    after = self._run(constant, value, shapes)
            except NotMeasured as problem:
                yield Outcome(constant, value, None, str(problem))
            except BuildFailed as problem:
                errors = [line for line in str(problem).splitlines() if "error" in line]
                yield Outcome(constant, value, None, errors[0] if errors else "does not build")
            else:
                yield Outcome(constant, value, compare(self._before, after))

    def chance(self) -> Iterator[tuple[str, str]]:
        """Yield, by group of shapes, what other seeds make of the figures without any change."""
        count = len(self._task.seeds)
        for name, shapes in GROUPS.items():
            before = self._task.run(self._build.executable, shapes)
            effects = []
            for shift in (count, 2 * count):
                other = replace(self._task, seeds=tuple(s + shift for s in self._task.seeds))
                after = [
                    replace(f, seed=f.seed - shift)
                    for f in other.run(self._build.executable, shapes)
                ]
                effects.append(str(compare(before, after)))
            yield name, "; ".join(effects)

    def _with_variables(self, constant: Constant) -> Path | None:
        """The program with the constants of a file as variables; None where that does not build."""
        if constant.file not in self._tunable:
            there = read_constants(self._root)
            mine = [
                there[key]
                for key, entry in CATALOGUE.items()
                if key[0] == constant.file and is_tunable(there[key], [entry.half, entry.double])
            ]
            text = (self._root / constant.path).read_text(encoding="utf-8")
            folder = self._scratch / constant.file.replace("/", "-")
            try:
                self._tunable[constant.file] = self._build.with_change(
                    constant.path, with_variables(text, mine), folder
                )
            except BuildFailed:
                self._tunable[constant.file] = None
        return self._tunable[constant.file]

    def _run(self, constant: Constant, value: str, shapes: tuple[str, ...]) -> list[Figures]:
        if constant.file == PARAMETERS:
            return self._task.run(self._build.executable, shapes, [f"{constant.name}={value}"])
        text = changed_text(
            self._root, constant.path, constant.text, constant.text_with(value), constant.name
        )
        with tempfile.TemporaryDirectory(dir=self._scratch) as folder:
            program = self._build.with_change(constant.path, text, Path(folder))
            return self._task.run(program, shapes)
