# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of shapes from its options to its print: benchmark.py --shapes."""

from __future__ import annotations

import argparse

from neuralmesh_tools.benchmarks.shapes.data import SHAPES
from neuralmesh_tools.benchmarks.shapes.run import Job, Measured
from neuralmesh_tools.command_line import listed, names
from neuralmesh_tools.isolation import IsolatedProcess

# What the project promises: time by that of a sphere of as many points.
MOST_RATIO = 5.0

HEADER = (
    "| shape | CPU, s | × a sphere | genus | parts | crossing faces | coverage, % |\n"
    "|---|--:|--:|--:|--:|--:|--:|"
)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add what only this table has."""
    group = parser.add_argument_group("shapes")
    text = f"shapes, comma separated, or all; of {listed(SHAPES)} (default: all)"
    group.add_argument("--kinds-of-shapes", default="all", metavar="NAMES", help=text)
    text = "of each cloud (default 20000); --vertices is 3000 by default here"
    group.add_argument("--shape-points", type=int, default=20_000, metavar="N", help=text)


def check_options(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Turn the list of names into a list; exits with 2 on one that is unknown."""
    options.kinds_of_shapes = names(parser, "shape", options.kinds_of_shapes, SHAPES)
    if options.shape_points < 1000:
        parser.error("--shape-points must be at least 1000")


def run_table(options: argparse.Namespace) -> int:
    """Run and print the table; return 1 if a shape misses the bar or could not be run."""
    print(HEADER)
    misses: list[str] = []
    usual = 0.0
    with IsolatedProcess() as process:
        for shape in ("", *options.kinds_of_shapes):
            job = Job(shape, options.shape_points, options.vertices or 3000, options.runs)
            outcome = process.call(
                "neuralmesh_tools.benchmarks.shapes.run:measure",
                job,
                cpu_timeout=options.timeout * options.runs,
            )
            if not outcome.ok:
                print(f"| {shape or 'sphere'} | {outcome.failure} | | | | | |", flush=True)
                misses.append(f"{shape or 'sphere'}: {outcome.failure}")
                continue
            found: Measured = outcome.value
            usual = usual or found.seconds
            print(_row(shape or "sphere", found, usual), flush=True)
            if found.seconds > MOST_RATIO * usual:
                misses.append(f"{shape}: {found.seconds / usual:.1f} times a sphere's time")
    print(f"\nShapes that take more than {MOST_RATIO:g} times as long: {len(misses)}")
    print("\n".join(f"- {miss}" for miss in misses))
    return 1 if misses else 0


def _row(name: str, found: Measured, usual: float) -> str:
    return (
        f"| {name} | {found.seconds:.2f} | {found.seconds / usual:.1f} | {found.genus} "
        f"| {found.components} | {found.self_intersections} | {100 * found.coverage:.1f} |"
    )
