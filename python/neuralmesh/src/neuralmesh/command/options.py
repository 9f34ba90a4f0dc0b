# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of a reconstruction: parameters of the filter as options."""

from __future__ import annotations

import argparse
from collections.abc import Collection
from pathlib import Path
from typing import Any

from .._core import __version__
from .._parameters import CHOICES
from .._reconstruct import DEFAULT_VERTICES
from ..files import most_points_for

LEAST_VERTICES = 4  # of a closed mesh
USAGE = """\
neuralmesh INPUT... -o OUTPUT [OPTION...]
       neuralmesh batch INPUT... --out DIR
       neuralmesh compare CLOUD... --out DIR
       neuralmesh info INPUT..."""
EPILOG = """\
reads   PLY, LAS, LAZ, COPC, E57, PCD, PTS, XYZ, CSV, NPY, NPZ, OBJ, STL, OFF, glTF, GLB
writes  PLY, OBJ, OFF, NPZ (exact); STL, GLB (single precision)
exit    0 done; 1 an input or a parameter cannot be used; 2 wrong usage; 130 interrupted
"""
PARAMETERS = """\
Further parameters of the filter:
  --topology learned|start       handles and parts of the points, or of the starting mesh
                                 (learned)
  --start-mesh tetrahedron|octahedron|icosahedron|data
                                 what the network grows from (tetrahedron)
  --transfer-attributes yes|no   the points' colours onto the mesh (yes)
  --edge-flips yes|no            flips that even out valences (yes)
  --split-rule balanced|paper    how a vertex is split (balanced)
  --threads N                    cores that share the work; 0 takes all (0)
  --time-limit SECONDS           ends with the mesh so far; 0: no limit (0)
  --winner-rate, --smoothing-rate, --smoothing-passes, --signals-per-split,
  --inactivity-factor, --counter-decay
                                 the paper's constants: 0.06, 0.05, 5, 100, 12, 0.995
"""
HIDDEN = (
    "topology",
    "start_mesh",
    "transfer_attributes",
    "edge_flips",
    "split_rule",
    "threads",
    "time_limit",
    "winner_rate",
    "smoothing_rate",
    "smoothing_passes",
    "signals_per_split",
    "inactivity_factor",
    "counter_decay",
)
SHOWN = ("vertices", "boundaries", "max_hole_size", "snapshots", "random_seed", "surface_fit")
SWITCHES = ("transfer_attributes", "edge_flips")
# What the user types for a parameter.
FLAGS = {key: "--" + key.replace("_", "-") for key in (*SHOWN, *HIDDEN, "most_points")}


class ShowParameters(argparse.Action):
    """--help-parameters prints the rest and ends."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        """Print and exit."""
        print(PARAMETERS, end="")
        parser.exit()


def parser() -> argparse.ArgumentParser:
    """Return the parser; its help fits on a screen."""
    made = argparse.ArgumentParser(
        prog="neuralmesh",
        usage=USAGE,
        description="Turn points into a triangle mesh of exactly so many vertices.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    add = made.add_argument
    add("inputs", nargs="+", type=Path, metavar="INPUT", help="a file, or a folder with --merge")
    add("-o", "--output", type=Path, required=True, help="the mesh; its ending is the format")
    add(
        "--merge", action="store_true", help="several files, or the tiles of a folder, as one cloud"
    )
    add_parameters(made)
    add("--json", action="store_true", help="print the results as JSON")
    add("-q", "--quiet", action="store_true", help="no progress bar and no log")
    add("--help-parameters", action=ShowParameters, nargs=0, help="the other parameters")
    add("--version", action="version", version=f"neuralmesh {__version__}")
    return made


def add_parameters(parser: argparse._ActionsContainer, without: Collection[str] = ()) -> None:
    """Add the filter's parameters as options, but those that are left out, by their keys."""

    def add(key: str, *short: str, **kind: Any) -> None:
        if key not in without:
            parser.add_argument(*short, FLAGS[key], **kind)

    add(
        "vertices",
        "-n",
        type=_vertices,
        metavar="N",
        help="of the mesh, at least 4 (5000, or half the points)",
    )
    add(
        "boundaries",
        choices=["closed", "open"],
        metavar="WHICH",
        help="closed: watertight; open: no surface where there are no points (closed)",
    )
    add(
        "max_hole_size",
        metavar="SIZE",
        help="smaller gaps in the points are closed: a length or a percentage (10%%)",
    )
    add("snapshots", metavar="N,N,...", help="also meshes of these sizes: OUTPUT_N")
    add("random_seed", metavar="N", help="the same seed gives the same mesh; 0: a fresh one (1)")
    parser.add_argument(
        "--no-surface-fit",
        dest="surface_fit",
        action="store_const",
        const=False,
        help="leave out the closing fit",
    )
    add(
        "most_points",
        type=int,
        metavar="N",
        help="kept of the input, a uniform choice; 0: all (500 a vertex, at least 2,000,000)",
    )
    for key in HIDDEN:
        add(key, choices=_choices(key), help=argparse.SUPPRESS)


def parameters_of(options: argparse.Namespace) -> tuple[dict[str, Any], dict[str, str]]:
    """Return the parameters that were given, and what the user typed for each."""
    parameters = {}
    for key in (*SHOWN, *HIDDEN):
        if (value := getattr(options, key, None)) is None:
            continue
        parameters[key] = value == "yes" if key in SWITCHES else value
    if "max_hole_size" in parameters and not parameters["max_hole_size"].strip().endswith("%"):
        parameters["max_hole_size"] = _number("--max-hole-size", parameters["max_hole_size"])
    return parameters, FLAGS


def most_points(options: argparse.Namespace) -> int | None:
    """How many points of an input are kept; None: all. Raises ValueError."""
    if options.most_points is not None:
        if options.most_points < 0:
            raise ValueError(f"--most-points must be at least 0, not {options.most_points}.")
        return options.most_points or None
    return most_points_for(options.vertices or DEFAULT_VERTICES)


def _vertices(text: str) -> int:
    """The type of --vertices."""
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"must be a whole number, not '{text}'") from None
    if number < LEAST_VERTICES:
        raise argparse.ArgumentTypeError(f"must be at least {LEAST_VERTICES}, not {number}")
    return number


def _number(flag: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{flag} must be a length or a percentage, not '{text}'.") from None


def _choices(key: str) -> list[str] | None:
    if key in SWITCHES:
        return ["yes", "no"]
    if key in CHOICES:
        return [name for name in CHOICES[key] if name != "given"]
    return None
