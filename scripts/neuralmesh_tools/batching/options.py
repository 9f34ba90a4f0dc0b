# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of a batch, whoever reconstructs: inputs, limits, workers; and its exit code."""

from __future__ import annotations

import argparse
import importlib.util
import os
import sys
from collections.abc import Callable, Collection
from pathlib import Path

from neuralmesh_tools.batching.folder import Locked
from neuralmesh_tools.batching.inputs import InputError, find_items
from neuralmesh_tools.batching.recipe import Recipe, RecipeError
from neuralmesh_tools.batching.run import INTERRUPTED, Settings, run_batch
from neuralmesh_tools.command_line import console, folder, positive
from neuralmesh_tools.files import shown
from neuralmesh_tools.project import PluginMissing

USAGE = 2


def add_inputs(parser: argparse.ArgumentParser, formats: str) -> None:
    """Add what a batch reads and where it writes; formats: some endings of its outputs."""
    parser.add_argument("inputs", nargs="*", metavar="IN", help="file, folder or quoted glob")
    text = "a text file with one IN a line"
    parser.add_argument("--list", type=Path, action="append", default=[], metavar="FILE", help=text)
    parser.add_argument("--out", type=folder, required=True, metavar="DIR", help="output folder")
    text = f"of the outputs: {formats} (default ply)"
    parser.add_argument("--format", default="ply", metavar="ENDING", help=text)


def add_how(parser: argparse.ArgumentParser) -> None:
    """Add by how many workers, and within what limits."""
    how = parser.add_argument_group("how")
    text = "items at a time on this machine (default: one a core)"
    how.add_argument("--workers", type=int, default=os.cpu_count(), metavar="N", help=text)
    how.add_argument("--threads", type=int, default=1, help="an item may use (default 1)")
    text = "a Dask scheduler to use instead, such as tcp://HOST:8786"
    how.add_argument("--scheduler", default="", metavar="ADDRESS", help=text)
    text = "an item is given up that has computed longer, on each of its threads (default 3600)"
    how.add_argument("--timeout", type=positive, default=3600, metavar="SECONDS", help=text)
    text = (
        "an item that grows beyond is given up: resident memory of its process, libraries "
        "included, looked at 50 times a second (default: no limit)"
    )
    how.add_argument("--memory", type=int, default=0, metavar="MB", help=text)
    text = "items before a process is replaced (default 20)"
    how.add_argument("--recycle", type=int, default=20, metavar="N", help=text)


def check(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Exit with 2 on numbers and combinations that make no sense."""
    for name in ("workers", "threads", "recycle"):
        if getattr(options, name) < 1:
            parser.error(f"--{name} must be at least 1")
    if options.memory < 0:
        parser.error("--memory must not be negative")
    if os.path.lexists(options.out) and not options.out.is_dir():
        parser.error(f"{options.out} is not a folder")
    if options.scheduler and importlib.util.find_spec("distributed") is None:
        parser.error("--scheduler needs Dask: pip install 'neuralmesh[cluster]'")


def run(
    options: argparse.Namespace, suffixes: Collection[str], make_recipe: Callable[[], Recipe]
) -> int:
    """Run a batch and return its exit code; what keeps it from running is said on standard error.

    suffixes: of the files that are taken from folders. make_recipe may raise RecipeError and
    PluginMissing.
    """
    settings = Settings(
        options.out,
        options.workers,
        options.scheduler,
        options.timeout,
        options.memory * 2**20,
        options.recycle,
    )
    try:
        inputs = find_items(options.inputs, options.list, options.out, suffixes)
        return run_batch(inputs, make_recipe(), settings, console())
    except KeyboardInterrupt:
        print("stopped before anything was run", file=sys.stderr)
        return INTERRUPTED
    except (InputError, RecipeError, PluginMissing, Locked) as problem:
        print(*map(shown, str(problem).splitlines()), sep="\n", file=sys.stderr)
    except OSError as problem:
        reason = f"{options.scheduler or options.out}: {problem}"
        print(shown(" ".join(reason.split())), file=sys.stderr)
    return USAGE


def suffix_of(options: argparse.Namespace) -> str:
    """The ending of the outputs, with its dot."""
    return "." + options.format.lower().lstrip(".")
