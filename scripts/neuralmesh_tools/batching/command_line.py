# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/batch.py, and all that can be wrong with it before anything runs."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from neuralmesh_tools.batching import preflight
from neuralmesh_tools.batching.folder import Locked
from neuralmesh_tools.batching.inputs import InputError, find_items
from neuralmesh_tools.batching.recipe import Recipe, RecipeError, parse_settings
from neuralmesh_tools.batching.run import INTERRUPTED, Settings, run_batch
from neuralmesh_tools.command_line import console, folder, parser_of, positive
from neuralmesh_tools.files import sha256_of, shown
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.machine import version_of
from neuralmesh_tools.project import PLUGIN, RECONSTRUCT, PluginMissing, require_plugin

USAGE = 2


def batch_parser(description: str | None) -> argparse.ArgumentParser:
    """The parser, with the script's own description."""
    parser = parser_of(description)
    parser.add_argument("inputs", nargs="*", metavar="IN", help="file, folder or quoted glob")
    text = "a text file with one IN a line"
    parser.add_argument("--list", type=Path, action="append", default=[], metavar="FILE", help=text)
    parser.add_argument("--out", type=folder, required=True, metavar="DIR", help="output folder")
    text = "of the outputs: ply, obj, stl, off, ... (default ply)"
    parser.add_argument("--format", default="ply", metavar="ENDING", help=text)

    recipe = parser.add_argument_group("what is done to each input")
    recipe.add_argument("--vertices", type=int, metavar="N", help="short for --set targetvertnum=N")
    text = "a parameter of the filter; may be repeated"
    recipe.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help=text)
    recipe.add_argument("--mlx", type=Path, metavar="FILE", help="a MeshLab filter script instead")
    text = "a PyMeshLab plugin to load; may be repeated (default: ours)"
    recipe.add_argument("--plugin", type=Path, action="append", metavar="FILE", help=text)

    how = parser.add_argument_group("how")
    text = "processes on this machine (default: one a core)"
    how.add_argument("--workers", type=int, default=os.cpu_count(), metavar="N", help=text)
    how.add_argument("--threads", type=int, default=1, help="an item may use (default 1)")
    text = "a Dask scheduler to use instead, such as tcp://HOST:8786"
    how.add_argument("--scheduler", default="", metavar="ADDRESS", help=text)
    text = "an item is given up that has computed longer, on each of its threads (default 3600)"
    how.add_argument("--timeout", type=positive, default=3600, metavar="SECONDS", help=text)
    text = (
        "an item that grows beyond is given up: resident memory of its process, PyMeshLab "
        "included, looked at 50 times a second (default: no limit)"
    )
    how.add_argument("--memory", type=int, default=0, metavar="MB", help=text)
    text = "items before a process is replaced (default 20)"
    how.add_argument("--recycle", type=int, default=20, metavar="N", help=text)
    return parser


def check_numbers(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Exit with 2 on numbers and combinations that make no sense."""
    for name in ("workers", "threads", "recycle"):
        if getattr(options, name) < 1:
            parser.error(f"--{name} must be at least 1")
    if options.memory < 0:
        parser.error("--memory must not be negative")
    if options.mlx and (options.set or options.vertices is not None):
        parser.error("--mlx holds its own parameters: --set and --vertices do not go with it")
    if os.path.lexists(options.out) and not options.out.is_dir():
        parser.error(f"{options.out} is not a folder")


def recipe_of(options: argparse.Namespace) -> Recipe:
    """Make the recipe and hold it against what PyMeshLab has.

    Raises RecipeError, and PluginMissing.
    """
    plugins = tuple(require_plugin(path) for path in options.plugin or [PLUGIN])
    suffix = "." + options.format.lower().lstrip(".")
    script, parameters = "", {}
    with IsolatedProcess() as process:
        preflight.check_suffix(process, suffix)
        if options.mlx:
            script = preflight.check_script(process, plugins, options.mlx)
        else:
            pairs = list(options.set)
            if options.vertices is not None:
                pairs.append(f"targetvertnum={options.vertices}")
            defaults = preflight.filter_defaults(process, plugins, RECONSTRUCT)
            parameters = parse_settings(pairs, defaults)
    versions = {"pymeshlab": version_of("pymeshlab")}
    versions |= {plugin.name: sha256_of(plugin) for plugin in plugins}
    return Recipe(plugins, RECONSTRUCT, parameters, script, suffix, options.threads, versions)


def main(description: str | None) -> int:
    """Read the command line, run the batch, return the exit code."""
    parser = batch_parser(description)
    options = parser.parse_intermixed_args()
    check_numbers(parser, options)
    settings = Settings(
        options.out,
        options.workers,
        options.scheduler,
        options.timeout,
        options.memory * 2**20,
        options.recycle,
    )
    try:
        inputs = find_items(options.inputs, options.list, options.out)
        return run_batch(inputs, recipe_of(options), settings, console())
    except KeyboardInterrupt:
        print("stopped before anything was run", file=sys.stderr)
        return INTERRUPTED
    except (InputError, RecipeError, PluginMissing, Locked) as problem:
        print(*map(shown, str(problem).splitlines()), sep="\n", file=sys.stderr)
    except OSError as problem:
        reason = f"{options.scheduler or options.out}: {problem}"
        print(shown(" ".join(reason.split())), file=sys.stderr)
    return USAGE
