# SPDX-License-Identifier: GPL-3.0-or-later
"""`neuralmesh batch INPUT... --out DIR`: many scans, each in a process of its own."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from neuralmesh_tools.batching import options as shared
from neuralmesh_tools.batching.recipe import Recipe, RecipeError
from neuralmesh_tools.files import sha256_of

from .. import _core, files
from .._parameters import read_options
from ..files.registry import SUFFIXES
from .options import ShowParameters, add_parameters, most_points, parameters_of

DESCRIPTION = """\
Reconstruct many scans, on all cores of this machine or on a Dask cluster.

Each scan runs in a process of its own: one that is broken, crashes, hangs or wants too much memory
is a line in DIR/report.csv and report.json, and the others go on. The same command again does only
what is missing, failed or changed. Ctrl-C stops; the same command goes on.
"""
EPILOG = """\
exit    0 every scan has its mesh; 1 some have failed; 2 nothing was run; 130 stopped
"""
BY = f"{__package__}.batch_item:reconstruct"
# One mesh for a scan, and the threads are those of a worker.
NOT_OF_A_BATCH = ("snapshots", "threads")


def run(arguments: Sequence[str]) -> int:
    """Run a batch; return the exit code."""
    parser = _parser()
    options = parser.parse_intermixed_args(arguments)
    shared.check(parser, options)
    return shared.run(options, SUFFIXES, lambda: recipe_of(options))


def _parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="neuralmesh batch",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    shared.add_inputs(made, ", ".join(suffix.lstrip(".") for suffix in files.WRITTEN))
    group = made.add_argument_group("what is done to each input")
    add_parameters(group, without=NOT_OF_A_BATCH)
    group.add_argument(
        "--help-parameters", action=ShowParameters, nargs=0, help="the other parameters"
    )
    shared.add_how(made)
    return made


def recipe_of(options: argparse.Namespace) -> Recipe:
    """Make the recipe of a batch; raises RecipeError on what no scan could be done with."""
    suffix = shared.suffix_of(options)
    if suffix not in files.WRITTEN:
        listed = ", ".join(files.WRITTEN)
        raise RecipeError(f"--format must be one of {listed}, not {suffix}.")
    try:
        parameters, names = parameters_of(options)
        del parameters["threads"]  # which change no result
        read_options(parameters, names)
        parameters["most_points"] = most_points(options) or 0
        if "vertices" in parameters:
            parameters["vertices"] = int(parameters["vertices"])
    except (ValueError, TypeError) as problem:
        raise RecipeError(str(problem)) from None
    versions = {
        "neuralmesh": _core.__version__,
        Path(_core.__file__).name: sha256_of(Path(_core.__file__)),
    }
    return Recipe((), "neuralmesh", parameters, "", suffix, options.threads, versions, BY)
