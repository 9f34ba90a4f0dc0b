# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality table from its options to its print: benchmark.py --quality."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from neuralmesh_tools import datasets
from neuralmesh_tools.command_line import listed, names
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.methods import TABLE_METHODS
from neuralmesh_tools.project import PluginMissing, require_plugin
from neuralmesh_tools.quality import bounds, models, report
from neuralmesh_tools.quality.inputs import CONDITIONS
from neuralmesh_tools.quality.run import Group, Row, Settings, Variant, run_group

ONLY_IF_NAMED = ("ours-no-fit",)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add what only the table has: which rows, how they are run, what is kept of them."""
    quality = parser.add_argument_group("quality")
    first = f"default: the first {len(models.TABLE_MODELS)}"
    text = f"comma separated, or all; of {listed(models.MODELS)} ({first})"
    quality.add_argument("--models", default=",".join(models.TABLE_MODELS), help=text)
    text = "comma separated (default: all)"
    quality.add_argument("--conditions", help=text)
    text = f"comma separated; of {listed(TABLE_METHODS)}"
    quality.add_argument("--methods", default="", help=text)
    text = "comma separated (default 1; --topology: 1 to 5)"
    quality.add_argument("--seeds", help=text)
    quality.add_argument("--timeout", type=float, default=300, help="seconds a row (default 300)")
    text = "a method (default 1: Poisson's threads spin and stall where others use the cores)"
    quality.add_argument("--threads", type=int, default=1, help=text)
    text = (
        "one more row of ours with these filter parameters; may be repeated. --topology: all rows "
        "with them"
    )
    quality.add_argument(
        "--ours", action="append", default=[], metavar="NAME=VALUE[,...]", help=text
    )
    quality.add_argument("--fresh", action="store_true", help="measure cached rows again")
    quality.add_argument("--keep", type=Path, metavar="DIR", help="keep the meshes that are run")
    quality.add_argument("--json", type=Path, metavar="FILE", help="write all rows")
    text = "an overview, and the bounds that the defaults have to keep to"
    quality.add_argument("--summary", action="store_true", help=text)


def check_options(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Turn lists of names into lists; exits with 2 on a model, condition or method unknown."""
    options.models = names(parser, "model", options.models, models.MODELS)
    options.conditions = names(parser, "condition", options.conditions or "all", CONDITIONS)
    options.methods = names(parser, "method", options.methods, TABLE_METHODS)
    try:
        options.seeds = [int(seed) for seed in (options.seeds or "1").split(",")]
        options.variants = [Variant("ours", parse_parameters(text)) for text in options.ours]
    except ValueError as problem:
        parser.error(str(problem))


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


def run_table(options: argparse.Namespace) -> int:
    """Run and print the table; return 1 if a row of ours failed or the plugin is missing."""
    wanted, missing = _variants(options)
    rows: list[Row] = []
    print(report.introduction(options.models, [variant.name for variant in wanted]), flush=True)
    for model in options.models:
        for condition in options.conditions:
            of_condition = CONDITIONS[condition].vertices
            vertices = options.vertices or of_condition or models.MODELS[model].vertices
            for seed in options.seeds:
                rows += _run_and_print(Group(model, condition, seed, vertices), wanted, options)
    if options.summary:
        print(f"\n## Overview\n{report.overview_markdown(rows)}")
        print(f"\n## Bounds\n\n{bounds.bounds_markdown(bounds.all_bounds(rows))}")
    if options.json:
        write_in_one_step(options.json, json.dumps(report.as_json(rows), indent=1))
    ours_failed = any(row.failed and row.method.startswith("ours") for row in rows)
    return 1 if missing or ours_failed else 0


def _variants(options: argparse.Namespace) -> tuple[list[Variant], bool]:
    """The rows to run, and whether ours had to be left out because the plugin is not there."""
    named = options.methods or [name for name in TABLE_METHODS if name not in ONLY_IF_NAMED]
    if options.summary and "ours" in named and "ours-no-fit" not in named:
        named = [*named, "ours-no-fit"]
    wanted = [Variant(name) for name in named] + options.variants
    peers = [variant for variant in wanted if variant.is_peer]
    if len(peers) < len(wanted):
        try:
            require_plugin(options.plugin)
        except PluginMissing as problem:
            print(f"{problem} Ours is left out.", file=sys.stderr)
            return peers, True
    return wanted, False


def _run_and_print(group: Group, wanted: list[Variant], options: argparse.Namespace) -> list[Row]:
    """Run the rows of one case; none, and a sentence, if its model cannot be had."""
    settings = Settings(
        options.plugin.resolve(), options.timeout, options.threads, options.fresh, options.keep
    )
    try:
        rows = list(run_group(group, wanted, settings))
    except datasets.Unavailable as problem:
        print(f"\n{group.model} is left out. {problem}", file=sys.stderr)
        return []
    if rows:
        print(report.group_markdown(group, rows), flush=True)
    return rows
