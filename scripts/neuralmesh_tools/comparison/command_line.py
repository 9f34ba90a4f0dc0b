# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/compare.py."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import Any

from rich.console import Console

from neuralmesh_tools.command_line import add_plugin, listed, names, parser_of
from neuralmesh_tools.comparison.clouds import REFERENCE_SAMPLES, load_surface
from neuralmesh_tools.comparison.measures import MESH_SAMPLES
from neuralmesh_tools.comparison.page import write_page
from neuralmesh_tools.comparison.run import LEAST_VERTICES, MEASURE_SECONDS, Settings, compare
from neuralmesh_tools.comparison.tables import write_tables
from neuralmesh_tools.comparison.verdict import judge
from neuralmesh_tools.files import sha256_of
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.machine import machine, version_of
from neuralmesh_tools.methods import METHODS
from neuralmesh_tools.project import PluginMissing, require_plugin


def parse_arguments(description: str | None) -> argparse.Namespace:
    """Read the command line; exits with 2 on what cannot work."""
    parser = parser_of(description)
    parser.add_argument("clouds", nargs="+", type=Path, metavar="CLOUD", help="point cloud or mesh")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="output folder")
    text = "measure against this surface instead of the cloud itself"
    parser.add_argument("--reference", type=Path, metavar="MESH", help=text)
    text = "of each result (default: 5000, but at most a quarter of the points)"
    parser.add_argument("--vertices", type=int, default=0, metavar="N", help=text)
    text = f"comma separated, of {listed(METHODS)} (default: all)"
    parser.add_argument("--methods", default=",".join(METHODS), metavar="NAMES", help=text)
    text = "distance that the F-score allows, in %% of the cloud's diagonal (default 0.1)"
    parser.add_argument("--threshold", type=float, default=0.1, metavar="PERCENT", help=text)
    text = "a method on a cloud is given up after that (default 60)"
    parser.add_argument("--timeout", type=float, default=60, metavar="SECONDS", help=text)
    text = "a method may use (default 1: Poisson's threads stall where others use the cores)"
    parser.add_argument("--threads", type=int, default=1, metavar="N", help=text)
    add_plugin(parser)
    options = parser.parse_intermixed_args()
    options.methods = names(parser, "method", options.methods, METHODS)
    if options.vertices and options.vertices < LEAST_VERTICES:
        parser.error(f"--vertices must be at least {LEAST_VERTICES}")
    if options.timeout <= 0 or options.threshold <= 0 or options.threads < 1:
        parser.error("--timeout, --threshold and --threads must be positive")
    for path in [*options.clouds, *filter(None, [options.reference])]:
        if not path.is_file():
            parser.error(f"there is no file {path}")
    if any(METHODS[name].exact for name in options.methods):
        try:
            require_plugin(options.plugin)
        except PluginMissing as problem:
            parser.error(str(problem))
    return options


def settings_of(options: argparse.Namespace) -> Settings:
    """Settings of the run; raises ValueError if the reference cannot be used."""
    surface = None
    if options.reference:
        with IsolatedProcess() as process:
            loaded = process.call(load_surface, str(options.reference), timeout=MEASURE_SECONDS)
        if not loaded.ok:
            raise ValueError(f"{options.reference}: {loaded.failure}")
        surface = loaded.value
    return Settings(
        options.methods,
        options.vertices,
        options.threshold,
        options.timeout,
        options.threads,
        options.plugin.resolve(),
        surface,
    )


def about_the_run(options: argparse.Namespace) -> dict[str, Any]:
    """What the report says of how it came about."""
    here = machine()
    if options.reference:
        against = f"the surface {options.reference.name}"
        distance = "Distances to it are exact."
    else:
        against = "the cloud itself"
        distance = (
            "A distance to the cloud is that to the tangent plane at the nearest point, so that "
            "the gaps between points are no error, but to the point itself where it is more than "
            "three spacings away."
        )
    return {
        "against": against,
        "measuring": (
            f"Errors are measured against {against}: from up to {REFERENCE_SAMPLES:,} points of it "
            f"to the result, exactly, and back from {MESH_SAMPLES:,} points drawn on the result, "
            f"uniformly by area. {distance} The F-score counts points within "
            f"{options.threshold:g} % of the cloud's diagonal. Colours show the "
            "RMS distance of each face, on one scale for all views of a cloud; what is beyond its "
            "end is as red as the end."
        ),
        "facts": {
            "date": time.strftime("%Y-%m-%d %H:%M"),
            "machine": f"{here['processor']}, {here['cores']} cores, "
            f"{here['memory_gigabytes']} GB, {here['system']}",
            "versions": f"PyMeshLab {version_of('pymeshlab')}, Python {here['python']}, "
            f"plugin {_short_hash(options.plugin)}",
            "threads": f"{options.threads} a method",
            "time-out": f"{options.timeout:g} s a method and cloud",
            "command": "scripts/compare.py " + " ".join(sys.argv[1:]),
        },
    }


def _short_hash(plugin: Path) -> str:
    """The beginning of the plugin's SHA-256, or that it is not there."""
    if not plugin.is_file():
        return "not there"
    return sha256_of(plugin)[:12]


def main(description: str | None) -> int:
    """Compare, write the report, print the answers. Returns the exit code."""
    options = parse_arguments(description)
    console = Console(highlight=False)
    try:
        settings = settings_of(options)
    except ValueError as problem:
        print(problem, file=sys.stderr)
        return 2
    options.out.mkdir(parents=True, exist_ok=True)
    with console.status("reading") as status:

        def say(line: str) -> None:
            console.print(line, markup=False, soft_wrap=True)
            status.update("next")

        comparisons = [compare(path, settings, say) for path in options.clouds]
    about = about_the_run(options)
    write_tables(comparisons, about, options.out)
    page = write_page(comparisons, about, options.out)
    for comparison in comparisons:
        verdict = judge(comparison)
        answer = f"{verdict.sentence} {verdict.more}"
        console.print(f"\n{comparison.name}: {answer}", markup=False, soft_wrap=True)
    console.print(f"\n{page}", markup=False, soft_wrap=True)
    answered = all(judge(comparison).method for comparison in comparisons)
    return 0 if answered else 1
