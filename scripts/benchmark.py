#!/usr/bin/env python3
"""Measures the neural mesh against screened Poisson and ball pivoting, in one run.

    benchmark.py --quality                        the README's table: eight models, four conditions
    benchmark.py --quality --models bunny,dino --conditions clean --methods ours
                                                  ours alone; peers' rows come from the cache
    benchmark.py --speed                          time, as a ratio, in one process
    benchmark.py --batch                          throughput of scripts/batch.py, two workers to one
    benchmark.py --file                           time and memory on a file of 100,000,000 points
    benchmark.py --quality --summary              an overview; what was asked, what was measured
    benchmark.py --quality --models bunny --ours splitrule=1 --ours smoothingpasses=3
                                                  more rows of ours, with other parameters

Peers' rows do not depend on our code: they are measured once and kept in the cache; --fresh
measures them again. Exit codes: 0 done, 1 a row of ours failed or the plugin is missing, 2 usage.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import datasets
import pymeshlab
from batch_speed import compare_workers
from file_benchmark import compare_file
from quality import bars, models, report
from quality.inputs import CONDITIONS
from quality.methods import METHODS
from quality.run import Group, Method, Row, Settings, run_group
from speed import compare_speed

ROOT = Path(__file__).resolve().parent.parent
ONLY_IF_ASKED = ("ours-no-fit", "poisson-cleaned")
DEFAULT_PLUGIN = ROOT / "build" / "pymeshlab" / "libfilter_neuralmesh.so"


def _add_what_to_measure(parser: argparse.ArgumentParser) -> None:
    what = parser.add_argument_group("what to measure")
    what.add_argument("--quality", action="store_true", help="errors, topology and shape")
    what.add_argument(
        "--speed", action="store_true", help="time against Poisson and decimation, on the bunny"
    )
    what.add_argument(
        "--batch",
        type=int,
        nargs="?",
        const=200,
        metavar="CLOUDS",
        help="throughput of batches of so many small clouds (default 200)",
    )
    what.add_argument(
        "--file",
        action="store_true",
        help="a point file on disk (1.2 GB, in the temporary folder, not kept) against 1,000,000 "
        "points in memory",
    )
    what.add_argument("--file-points", type=int, default=100_000_000, help="(default 100000000)")
    what.add_argument(
        "--runs",
        type=int,
        default=5,
        help="of each, for --speed, --batch and --file (default 5)",
    )


def parse_arguments() -> argparse.Namespace:
    """Read the command line; exits with 2 on unknown models, conditions or methods."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    _add_what_to_measure(parser)
    quality = parser.add_argument_group("quality")
    quality.add_argument(
        "--models",
        default=",".join(models.TABLE_MODELS),
        help=f"comma separated, or all; of {', '.join(models.MODELS)} (default: the first eight)",
    )
    quality.add_argument(
        "--conditions", default=",".join(CONDITIONS), help="comma separated (default: all)"
    )
    quality.add_argument("--methods", default="", help=f"comma separated; of {', '.join(METHODS)}")
    quality.add_argument("--vertices", type=int, help="of each result (default: the model's own)")
    quality.add_argument("--seeds", default="1", help="comma separated (default 1)")
    quality.add_argument("--timeout", type=float, default=300, help="seconds a row (default 300)")
    quality.add_argument(
        "--threads",
        type=int,
        default=1,
        help="a method (default 1: Poisson's threads spin and stall where others use the cores)",
    )
    quality.add_argument(
        "--ours",
        action="append",
        default=[],
        metavar="NAME=VALUE[,...]",
        help="one more row of ours with these filter parameters; may be repeated",
    )
    quality.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN, help="the built plugin")
    quality.add_argument("--fresh", action="store_true", help="measure cached rows again")
    quality.add_argument("--keep", type=Path, metavar="DIR", help="keep the meshes that are run")
    quality.add_argument("--json", type=Path, metavar="FILE", help="write all rows")
    quality.add_argument(
        "--summary", action="store_true", help="an overview, and asked and measured"
    )
    options = parser.parse_args()
    if not (options.quality or options.speed or options.batch or options.file):
        parser.error("nothing to measure: give --quality, --speed, --batch or --file")
    options.models = _names(parser, "model", options.models, list(models.MODELS))
    options.conditions = _names(parser, "condition", options.conditions, list(CONDITIONS))
    options.methods = _names(parser, "method", options.methods, list(METHODS))
    try:
        options.seeds = [int(seed) for seed in options.seeds.split(",")]
        options.variants = [Method("ours", parse_parameters(text)) for text in options.ours]
    except ValueError as problem:
        parser.error(str(problem))
    if options.vertices is not None and options.vertices < 4:
        parser.error("--vertices must be at least 4")
    return options


def _names(parser: argparse.ArgumentParser, kind: str, text: str, known: list[str]) -> list[str]:
    if text == "all":
        return known
    names = [name for name in text.split(",") if name]
    for name in names:
        if name not in known:
            parser.error(f"unknown {kind} {name}; there are {', '.join(known)}")
    return names


def parse_parameters(text: str) -> dict[str, object]:
    """Turn NAME=VALUE,... into filter parameters; a value is read as JSON, else as text."""
    parameters: dict[str, object] = {}
    for pair in text.split(","):
        name, equals, value = pair.partition("=")
        if not equals:
            raise ValueError(f"--ours wants NAME=VALUE, not {pair}")
        try:
            parameters[name.lower()] = json.loads(value.lower())
        except json.JSONDecodeError:
            parameters[name.lower()] = value
    return parameters


def chosen_methods(options: argparse.Namespace) -> tuple[list[Method], bool]:
    """The methods to run, and whether ours had to be left out because the plugin is not there."""
    names = options.methods or [name for name in METHODS if name not in ONLY_IF_ASKED]
    if options.summary and "ours" in names and "ours-no-fit" not in names:
        names.append("ours-no-fit")
    wanted = [Method(name) for name in names] + options.variants
    if options.plugin.is_file() or all(method.is_peer for method in wanted):
        return wanted, False
    print(f"{options.plugin} is not there: run scripts/build. Ours is left out.", file=sys.stderr)
    return [method for method in wanted if method.is_peer], True


def _helped_peers(options: argparse.Namespace, condition: str) -> list[Method]:
    """Peers with the help that a user gives them where the input calls for it."""
    wanted = CONDITIONS[condition].outliers > 0 and not options.methods
    return [Method("poisson-cleaned")] if wanted else []


def run_quality(options: argparse.Namespace) -> int:
    """Run and print the quality table; returns the exit code."""
    wanted, missing = chosen_methods(options)
    settings = Settings(
        str(options.plugin.resolve()),
        options.timeout,
        options.threads,
        options.fresh,
        options.keep,
    )
    rows: list[Row] = []
    print(f"{report.LEGEND}\n\n{report.why_these(options.models)}", flush=True)
    for model in options.models:
        vertices = options.vertices or models.MODELS[model].vertices
        for condition in options.conditions:
            for seed in options.seeds:
                group = Group(model, condition, seed, vertices)
                try:
                    these = wanted + _helped_peers(options, condition)
                    done = list(run_group(group, these, settings))
                except datasets.Unavailable as problem:
                    print(f"\n{model} is left out. {problem}", file=sys.stderr)
                    continue
                if done:
                    print(report.group_markdown(group, done), flush=True)
                rows += done
    if options.summary:
        print(f"\n## Overview\n{report.overview_markdown(rows)}")
        print(f"\n## Asked and measured\n\n{bars.bars_markdown(bars.all_bars(rows))}")
    if options.json:
        options.json.parent.mkdir(parents=True, exist_ok=True)
        options.json.write_text(json.dumps(report.as_json(rows), indent=1), encoding="utf-8")
    ours_failed = any(row.failed and row.method.startswith("ours") for row in rows)
    return 1 if missing or ours_failed else 0


def main() -> int:
    """Run what the command line asks for."""
    options = parse_arguments()
    if options.speed:
        pymeshlab.load_plugin(str(options.plugin))
        print(compare_speed(options.vertices or 5000, options.runs).text(), flush=True)
    if options.batch:
        print(compare_workers(options.batch, options.runs).text(), flush=True)
    if options.file:
        vertices = options.vertices or 5000
        print(compare_file(options.plugin, options.file_points, vertices, options.runs), flush=True)
    return run_quality(options) if options.quality else 0


if __name__ == "__main__":
    sys.exit(main())
