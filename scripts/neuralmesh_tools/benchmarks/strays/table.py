# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of strays from its options to its print: benchmark.py --strays."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from neuralmesh_tools import datasets
from neuralmesh_tools.benchmarks.strays.data import BODIES, KINDS, NEAREST
from neuralmesh_tools.benchmarks.strays.run import SEEDS, Job
from neuralmesh_tools.command_line import listed, names
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.project import require_plugin

COUNTS = (2, 5, 20, 60, 100, 500)
REACHES = (1.5, 3.0, 10.0, 100.0, 1e4, 1e7)
# What the project promises: the RMS with strays by that without them.
MOST_RATIO = 1.1

LEGEND = f"""RMS distance to the true surface with strays, by that without them (the worse of both
directions, in the median of {len(SEEDS)} seeds), at most {MOST_RATIO:g}; "=" where the mesh is the
very same. Behind it, where they differ, how many points the log says were left out, by how many
strays there are. Columns: the strays lie {NEAREST:g} to so many radii from the cloud's middle.
single: uniform in space. tails: as many at each order of distance. repeated: single, each stored up
to 1,000 times. clumps: ten close together."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add what only this table has."""
    group = parser.add_argument_group("strays")
    text = f"clouds, comma separated, or all; of {listed(BODIES)} (default: all)"
    group.add_argument("--clouds", default="all", help=text)
    text = f"of strays, comma separated, or all; of {listed(KINDS)} (default: all)"
    group.add_argument("--kinds", default="all", help=text)


def check_options(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Turn lists of names into lists; exits with 2 on a cloud or kind unknown."""
    options.clouds = names(parser, "cloud", options.clouds, BODIES)
    options.kinds = names(parser, "kind", options.kinds, KINDS)


def run_table(options: argparse.Namespace) -> int:
    """Run and print the table; return 1 if a case misses the bar or could not be run.

    Raises PluginMissing if there is no plugin.
    """
    plugin = require_plugin(options.plugin)
    print(LEGEND)
    misses: list[str] = []
    with IsolatedProcess({"OMP_NUM_THREADS": str(options.threads)}) as process:
        for cloud in options.clouds:
            heading = " | ".join(f"{reach:g}" for reach in REACHES)
            print(f"\n| {cloud} | strays | {heading} |\n|---|--:|" + "--:|" * len(REACHES))
            for kind in options.kinds:
                for count in COUNTS:
                    row = _row(process, plugin, cloud, kind, count)
                    cells = " | ".join(_cell(values) for values in row)
                    print(f"| {kind} | {count} | {cells} |", flush=True)
                    misses += [
                        f"{cloud}, {kind}, {count} within {reach:g}: {_cell(values)}"
                        for reach, values in zip(REACHES, row, strict=True)
                        if is_missed(values)
                    ]
    print(f"\nCases worse than {MOST_RATIO:g}: {len(misses)}")
    print("\n".join(f"- {miss}" for miss in misses))
    return 1 if misses else 0


def is_missed(values: dict[str, Any]) -> bool:
    """Whether there is no mesh, or one further from the surface than it may be."""
    return "failure" in values or values["ratio"] > MOST_RATIO


def _row(
    process: IsolatedProcess, plugin: Path, cloud: str, kind: str, count: int
) -> list[dict[str, Any]]:
    """Figures of one kind and count, a reach after the other."""
    cases = tuple((kind, count, reach) for reach in REACHES)
    try:
        datasets_ready(cloud)
    except datasets.Unavailable as problem:
        print(f"{cloud} is left out. {problem}", file=sys.stderr)
        return [{"failure": "could not be had"}] * len(REACHES)
    job = Job(plugin, cloud, cases)
    outcome = process.call("neuralmesh_tools.benchmarks.strays.run:measure_body", job, timeout=1200)
    if outcome.ok:
        found: list[dict[str, Any]] = outcome.value
        return found
    return [{"failure": outcome.failure}] * len(REACHES)


def datasets_ready(cloud: str) -> None:
    """Fetch what the cloud is made of; raises datasets.Unavailable if it cannot be had."""
    BODIES[cloud]()


def _cell(values: dict[str, Any]) -> str:
    if "failure" in values:
        return str(values["failure"])
    ratio = "=" if values["same"] else f"{values['ratio']:.3f}"
    told = values["left_out"] - values["without"]
    return ratio if told == values["strays"] else f"{ratio} ({told:,} of {values['strays']:,})"
