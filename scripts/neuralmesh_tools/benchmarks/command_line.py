# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/benchmark.py."""

from __future__ import annotations

import argparse
import json
import sys

from neuralmesh_tools.benchmarks import scale
from neuralmesh_tools.benchmarks.batches import compare_workers
from neuralmesh_tools.benchmarks.point_file import compare_file
from neuralmesh_tools.benchmarks.shapes import table as shapes_table
from neuralmesh_tools.benchmarks.speed import compare_speed
from neuralmesh_tools.benchmarks.strays import table as strays_table
from neuralmesh_tools.benchmarks.topology import table as topology_table
from neuralmesh_tools.command_line import add_plugin, parser_of
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.project import PluginMissing, require_plugin
from neuralmesh_tools.quality import table

DEFAULT_VERTICES = 5000

SCALE = {
    "vertices": [1000, 10_000, 100_000],
    "points": [100_000, 1_000_000, 2_000_000],
    "threads": [1, 2],
}
"""Counts that --scale takes where none are given."""


def _counts(text: str) -> list[int]:
    return [int(count) for count in text.split(",")]


def parse_arguments(description: str | None) -> argparse.Namespace:
    """Read the command line; exits with 2 on what cannot work."""
    parser = parser_of(description)
    what = parser.add_argument_group("what to measure")
    what.add_argument("--quality", action="store_true", help="errors, topology and shape")
    text = "handles, parts and borders, against what the data have"
    what.add_argument("--topology", action="store_true", help=text)
    text = "whether a few points far off change the mesh of a cloud"
    what.add_argument("--strays", action="store_true", help=text)
    text = "whether clouds of difficult shapes take longer than a sphere's"
    what.add_argument("--shapes", action="store_true", help=text)
    text = "time against Poisson and decimation, on the bunny"
    what.add_argument("--speed", action="store_true", help=text)
    text = "time against vertices, points and threads, on the armadillo"
    what.add_argument("--scale", action="store_true", help=text)
    for name, default in SCALE.items():
        text = f"of --scale, separated by commas (default {','.join(map(str, default))})"
        what.add_argument(f"--scale-{name}", type=_counts, default=default, metavar="N", help=text)
    text = "throughput of batches of so many small clouds (default 200)"
    what.add_argument("--batch", type=int, nargs="?", const=200, metavar="CLOUDS", help=text)
    text = (
        "a point file on disk (1.2 GB, in the temporary folder, not kept) against 1,000,000 "
        "points in memory"
    )
    what.add_argument("--file", action="store_true", help=text)
    what.add_argument("--file-points", type=int, default=100_000_000, help="(default 100000000)")
    text = "of each, for --speed, --scale, --shapes, --batch and --file (default 5)"
    what.add_argument("--runs", type=int, default=5, help=text)
    text = "of each result (default 5000; --shapes: 3000; --quality, --topology: the model's own)"
    what.add_argument("--vertices", type=int, metavar="N", help=text)
    add_plugin(what)
    table.add_options(parser)
    topology_table.add_options(parser)
    strays_table.add_options(parser)
    shapes_table.add_options(parser)
    options = parser.parse_args()
    tables = (options.quality, options.topology, options.strays)
    others = (options.shapes, options.speed, options.scale, options.batch, options.file)
    if not any((*tables, *others)):
        parser.error(
            "nothing to measure: give --quality, --topology, --strays, --shapes, --speed, --scale, "
            "--batch or --file"
        )
    if sum(tables) > 1:
        parser.error("--quality, --topology and --strays share options: give one of them")
    if options.vertices is not None and options.vertices < 4:
        parser.error("--vertices must be at least 4")
    if min(options.scale_vertices) < 4 or min(options.scale_points) < 4:
        parser.error("--scale-vertices and --scale-points must be at least 4")
    strays_table.check_options(parser, options)
    shapes_table.check_options(parser, options)
    (topology_table if options.topology else table).check_options(parser, options)
    return options


def _print_scale(options: argparse.Namespace) -> None:
    chosen = scale.cases(options.scale_vertices, options.scale_points, options.scale_threads)
    print(scale.HEADER, flush=True)
    rows = []
    for row in scale.measure(chosen, options.runs):
        rows.append(row.as_json())
        print(row.text(), flush=True)
    if options.json:
        write_in_one_step(options.json, json.dumps(rows, indent=1))


def main(description: str | None) -> int:
    """Measure what the command line asks for, and return the exit code."""
    options = parse_arguments(description)
    vertices = options.vertices or DEFAULT_VERTICES
    try:
        if options.speed:
            plugin = require_plugin(options.plugin)
            print(compare_speed(plugin, vertices, options.runs).text(), flush=True)
        if options.scale:
            _print_scale(options)
        if options.batch:
            print(compare_workers(options.batch, options.runs).text(), flush=True)
        if options.file:
            plugin = require_plugin(options.plugin)
            print(compare_file(plugin, options.file_points, vertices, options.runs), flush=True)
        if options.shapes:
            return shapes_table.run_table(options)
        if options.strays:
            return strays_table.run_table(options)
        if options.topology:
            return topology_table.run_table(options)
    except PluginMissing as problem:
        print(problem, file=sys.stderr)
        return 1
    return table.run_table(options) if options.quality else 0
