# SPDX-License-Identifier: GPL-3.0-or-later
"""The topology table in Markdown: a line a row and condition, over all its seeds."""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from neuralmesh_tools.benchmarks.topology.data import CONDITIONS
from neuralmesh_tools.benchmarks.topology.judge import (
    LEAST_COVERED,
    MOST_TIMES_BUNNY,
    SIZE_TOLERANCE,
    Run,
    faults,
    missed,
    needed,
)
from neuralmesh_tools.benchmarks.topology.rows import ROWS, Expected

HEADINGS = (
    "data, vertices",
    "condition",
    "expected",
    "right",
    "needed",
    "otherwise",
    "exact V",
    "self-int.",
    "covered %",
    "coverage %",
    "unsupported %",
    "RMS to mesh / surface %",
    "s / 1,000 V",
    "missed",
)

LEGEND = f"""right: runs whose mesh is as expected, is an oriented two-manifold, has the exact count
of vertices and, on clean points, no self-intersection. otherwise: what the others are, and how
many. exact V: runs with the exact count. self-int.: faces that intersect another, most of any run.
covered: share of the clean points within half a mean edge of the mesh, least of any run; whole
means at least {100 * LEAST_COVERED:g} %. coverage, unsupported: the filter's own figures, worst of
any run; no surplus means at most {100 * SIZE_TOLERANCE:g} % of the area unsupported, besides
holes of the data that are closed. Volume and diagonal may differ by {100 * SIZE_TOLERANCE:g} %.
RMS: median, in per cent of the surface's diagonal, from the surface to the mesh / back, uniform by
area. s: median CPU seconds, at most {MOST_TIMES_BUNNY:g} times those of the clean bunny."""


def head() -> str:
    """The table's head."""
    return f"| {' | '.join(HEADINGS)} |\n|---|---|---|" + "--:|" * (len(HEADINGS) - 4) + "---|"


def line(runs: Sequence[Run], bunny: float) -> str:
    """The line of one row and condition; bunny: see judge.missed."""
    first = runs[0]
    row = ROWS[first.row]
    found = [faults(run, row.expected) for run in runs]
    others = Counter(", ".join(words) for words in found if words)
    done = [run.values for run in runs if not run.failed]
    cells = [
        f"{first.row}, {first.target:,}",
        CONDITIONS[first.condition].label,
        described(row.expected),
        f"{sum(not words for words in found)} of {len(runs)}",
        str(needed(first.row, first.condition, len(runs))),
        "; ".join(f"{words} (×{count})" for words, count in others.items()),
        str(sum(values["vertices"] == first.target for values in done)),
        str(max((values["self_intersecting"] for values in done), default="–")),
        _worst(done, "covered", min),
        _worst(done, "coverage", min),
        _worst(done, "unsupported_area", max),
        _both_ways(done),
        f"{statistics.median(run.seconds for run in runs if not run.failed):.2f}" if done else "–",
        "; ".join(missed(runs, bunny)),
    ]
    return f"| {' | '.join(cells)} |"


def overview(runs: Sequence[Run]) -> str:
    """A table of how many runs are right, a line a row, a column a condition."""
    right: dict[tuple[str, str], list[bool]] = {}
    for run in runs:
        found = right.setdefault((run.row, run.condition), [])
        found.append(not faults(run, ROWS[run.row].expected))
    conditions = [name for name in CONDITIONS if any(run.condition == name for run in runs)]
    labels = " | ".join(CONDITIONS[name].label for name in conditions)
    lines = [f"| data | expected | {labels} |", "|---|---|" + "--:|" * len(conditions)]
    for row in dict.fromkeys(run.row for run in runs):
        cells = [_share(right.get((row, name)), row, name) for name in conditions]
        lines.append(f"| {row} | {described(ROWS[row].expected)} | {' | '.join(cells)} |")
    return "\n".join(lines)


def _share(right: list[bool] | None, row: str, condition: str) -> str:
    """Right runs of all; bold where they are fewer than needed."""
    if right is None:
        return ""
    text = f"{sum(right)} of {len(right)}"
    return text if sum(right) >= needed(row, condition, len(right)) else f"**{text}**"


def described(expected: Expected) -> str:
    """What is expected, in a few words."""
    words = []
    if expected.components > 1:
        words.append(f"{expected.components} parts")
    if expected.genus is not None:
        words.append(f"genus {expected.genus}")
    fewest, most = expected.loops
    loops = f"{fewest}" if fewest == most else f"{fewest} to {most}"
    words.append(f"{loops} loop{'s' * (most > 1)}" if most else "closed")
    if expected.whole:
        words.append("whole")
    if expected.no_surplus:
        words.append("no surplus")
    if expected.no_crossing:
        words.append("no crossing")
    if expected.window is not None:
        words.append("hole free")
    words += [name for name in ("volume", "diagonal") if getattr(expected, name) is not None]
    return ", ".join(words)


def _worst(done: list[dict[str, Any]], name: str, worst: Any) -> str:
    values = [run[name] for run in done if run[name] is not None]
    return f"{100 * worst(values):.1f}" if values else "–"


def _both_ways(done: list[dict[str, Any]]) -> str:
    if not done or "rms_to_mesh" not in done[0]:
        return "–"
    medians = (
        statistics.median(run[name] for run in done) for name in ("rms_to_mesh", "rms_to_surface")
    )
    return " / ".join(f"{median:.3f}" for median in medians)


def as_json(runs: Sequence[Run]) -> list[dict[str, Any]]:
    """Runs as plain dictionaries, with their faults."""
    return [asdict(run) | {"faults": faults(run, ROWS[run.row].expected)} for run in runs]
