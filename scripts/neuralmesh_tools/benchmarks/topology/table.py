# SPDX-License-Identifier: GPL-3.0-or-later
"""The topology table from its options to its print: benchmark.py --topology."""

from __future__ import annotations

import argparse
import json
import statistics
import sys

from neuralmesh_tools import datasets
from neuralmesh_tools.benchmarks.topology import report
from neuralmesh_tools.benchmarks.topology.data import CONDITIONS, SPARSE_VERTICES, made
from neuralmesh_tools.benchmarks.topology.judge import Run, missed
from neuralmesh_tools.benchmarks.topology.rows import ROWS
from neuralmesh_tools.benchmarks.topology.run import Job
from neuralmesh_tools.command_line import listed, names
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.methods import Task
from neuralmesh_tools.project import require_plugin
from neuralmesh_tools.quality.table import parse_parameters

DEFAULT_SEEDS = "1,2,3,4,5"
BUNNY_RUNS = 3


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add what only this table has; the other options are the quality table's."""
    topology = parser.add_argument_group(
        "topology", "with --conditions, --seeds, --timeout, --threads, --ours, --keep, --json"
    )
    text = f"comma separated, or all; of {listed(ROWS).replace('%', '%%')} (default: all)"
    topology.add_argument("--rows", default="all", help=text)


def check_options(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Turn lists of names into lists; exits with 2 on a row or condition unknown."""
    options.rows = names(parser, "row", options.rows, ROWS)
    options.conditions = names(parser, "condition", options.conditions or "all", CONDITIONS)
    try:
        options.seeds = [int(seed) for seed in (options.seeds or DEFAULT_SEEDS).split(",")]
        options.ours_parameters = {
            name: value for text in options.ours for name, value in parse_parameters(text).items()
        }
    except ValueError as problem:
        parser.error(str(problem))


def run_table(options: argparse.Namespace) -> int:
    """Run and print the table; return 1 if a row misses a bar or could not be run.

    Raises PluginMissing if there is no plugin.
    """
    options.plugin = require_plugin(options.plugin)
    environment = {"OMP_NUM_THREADS": str(options.threads)}
    runs: list[Run] = []
    misses: list[str] = []
    with IsolatedProcess(environment) as process:
        bunny = _seconds_of_bunny(process, options)
        if bunny is None:
            return 1
        print(f"{report.LEGEND}\n\nThe clean bunny: {bunny:.2f} s / 1,000 V.\n\n{report.head()}")
        for row in options.rows:
            for condition in (name for name in options.conditions if name in ROWS[row].conditions):
                try:
                    found = [_run(process, options, row, condition, n) for n in options.seeds]
                except datasets.Unavailable as problem:
                    print(f"{row} is left out. {problem}", file=sys.stderr)
                    misses.append(f"{row}: could not be had")
                    break
                print(report.line(found, bunny), flush=True)
                runs += found
                misses += [f"{row}, {condition}: {words}" for words in missed(found, bunny)]
    print(f"\n{report.overview(runs)}\n\nBars missed: {len(misses)}")
    print("\n".join(f"- {miss}" for miss in misses))
    if options.json:
        write_in_one_step(options.json, json.dumps(report.as_json(runs), indent=1))
    return 1 if misses else 0


def _seconds_of_bunny(process: IsolatedProcess, options: argparse.Namespace) -> float | None:
    """CPU seconds for 1,000 vertices of the clean bunny, the median of BUNNY_RUNS seeds.

    None, and a sentence, where no run gives a mesh: then there is nothing to hold others to.
    """
    seeds = range(1, BUNNY_RUNS + 1)
    runs = [_run(process, options, "bunny", "clean", seed) for seed in seeds]
    done = [run.seconds for run in runs if not run.failed]
    if not done:
        print(f"The bunny fails: {runs[0].values['failure']}", file=sys.stderr)
        return None
    return statistics.median(done)


def _run(
    process: IsolatedProcess, options: argparse.Namespace, name: str, condition: str, seed: int
) -> Run:
    row = ROWS[name]
    target = options.vertices or (SPARSE_VERTICES if condition == "sparse" else row.vertices)
    parameters = {**row.parameters, "randomseed": seed, **options.ours_parameters}
    task = Task(target, options.threads, parameters=parameters)
    mesh = None
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
        mesh = options.keep.resolve() / f"{name}-{condition}-{seed}.ply"
    cloud = made(row.maker, row.points, condition, seed)
    outcome = process.call(
        "neuralmesh_tools.benchmarks.topology.run:measure_run",
        Job(options.plugin, cloud, task, row.expected.window, mesh),
        timeout=options.timeout,
    )
    values = outcome.value if outcome.ok else {"failure": outcome.failure}
    return Run(name, condition, seed, target, values)
