# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with a mesh, and whether the runs of a row are right often enough."""

from __future__ import annotations

import statistics
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from neuralmesh_tools.benchmarks.topology.rows import ROWS, Expected

# What the project promises of the rows, not what was measured.
LEAST_COVERED = 0.99
# Of volume, of the bounding box's diagonal, and of the area of an open mesh.
SIZE_TOLERANCE = 0.05
MOST_TIMES_BUNNY = 3.0


@dataclass(frozen=True)
class Run:
    """One reconstruction; values holds its figures, or {"failure": sentence}."""

    row: str
    condition: str
    seed: int
    target: int
    values: dict[str, Any]

    @property
    def failed(self) -> bool:
        """Whether there is no mesh."""
        return "failure" in self.values

    @property
    def seconds(self) -> float:
        """CPU seconds for 1,000 vertices."""
        return float(1000 * self.values["cpu_seconds"] / self.target)


def faults(run: Run, expected: Expected) -> list[str]:
    """What is wrong with a run, a few words each; nothing if it is right."""
    if run.failed:
        return [f"failed: {run.values['failure']}"]
    return _defects(run, expected) + _wrong_shape(run.values, expected)


def _defects(run: Run, expected: Expected) -> list[str]:
    """What no mesh may be, whatever its data."""
    v = run.values
    found = []
    if v["vertices"] != run.target:
        found.append(f"{v['vertices']:,} vertices")
    if not v["two_manifold"]:
        found.append("not two-manifold")
    if not v["oriented"]:
        found.append("not oriented")
    if v["self_intersecting"] and (expected.no_crossing or run.condition == "clean"):
        found.append("crossing faces")
    return found


def _wrong_shape(v: dict[str, Any], expected: Expected) -> list[str]:
    found = []
    if v["components"] != expected.components:
        found.append(f"{v['components']} components")
    if expected.genus is not None and v["genus"] != expected.genus:
        found.append(f"genus {v['genus']}")
    if not expected.loops[0] <= v["loops"] <= expected.loops[1]:
        found.append(f"{v['loops']} loops")
    if expected.whole and v["covered"] < LEAST_COVERED:
        found.append(f"covered {100 * v['covered']:.1f} %")
    if expected.no_surplus and v["unsupported_area"] > SIZE_TOLERANCE + expected.gaps:
        found.append(f"unsupported {100 * v['unsupported_area']:.0f} %")
    for name, true in (("volume", expected.volume), ("diagonal", expected.diagonal)):
        if true is not None and abs(v[name] / true - 1) > SIZE_TOLERANCE:
            found.append(f"{name} {100 * (v[name] / true - 1):+.0f} %")
    if v["in_window"]:
        found.append("faces across the hole")
    return found


def needed(row: str, condition: str, runs: int) -> int:
    """How many of so many runs have to be right: at_least of 5, one less where not clean.

    Of fewer or more than 5 runs, the same share, rounded up.
    """
    of_five = ROWS[row].at_least - (condition != "clean")
    return -(-of_five * runs // 5)


def missed(runs: Sequence[Run], bunny: float) -> list[str]:
    """Which bars the runs of one row and condition miss; bunny: its seconds for 1,000 vertices."""
    row, condition = runs[0].row, runs[0].condition
    right = sum(not faults(run, ROWS[row].expected) for run in runs)
    least = needed(row, condition, len(runs))
    found = []
    if right < least:
        found.append(f"{right} of {len(runs)} right, not {least}")
    done = [run.seconds for run in runs if not run.failed]
    if done and statistics.median(done) > MOST_TIMES_BUNNY * bunny:
        found.append(f"{statistics.median(done) / bunny:.1f} × the bunny's time")
    return found
