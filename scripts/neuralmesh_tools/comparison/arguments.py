# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of a comparison. Needs no package of those that a comparison needs."""

from __future__ import annotations

import argparse
from collections.abc import Collection
from pathlib import Path

from neuralmesh_tools.command_line import folder, listed, parser_of, positive

COMMAND = "neuralmesh compare"


def parser_for_clouds(
    description: str | None, command: str | None, methods: Collection[str]
) -> argparse.ArgumentParser:
    """Return the parser of a comparison.

    command: what the user typed, None for the name of the script. methods: those that there are;
    none where the package that has them is missing.
    """
    parser = parser_of(description)
    if command is not None:
        parser.prog = command
    parser.add_argument("clouds", nargs="+", type=Path, metavar="CLOUD", help="point cloud or mesh")
    parser.add_argument("--out", type=folder, required=True, metavar="DIR", help="output folder")
    text = "measure against this surface instead of the cloud itself"
    parser.add_argument("--reference", type=Path, metavar="MESH", help=text)
    text = "of each result (default: 5000, but at most a quarter of the points)"
    parser.add_argument("--vertices", type=int, default=0, metavar="N", help=text)
    text = f"comma separated, of {listed(methods)} (default: all)" if methods else "(default: all)"
    default = ",".join(methods)
    parser.add_argument("--methods", default=default, metavar="NAMES", help=text)
    text = "distance that the F-score allows, in %% of the cloud's diagonal (default 0.1)"
    parser.add_argument("--threshold", type=positive, default=0.1, metavar="PERCENT", help=text)
    text = "a method is given up that computes longer, on each of its threads (default 60)"
    parser.add_argument("--timeout", type=positive, default=60, metavar="SECONDS", help=text)
    text = "a method may use (default 1: Poisson's threads stall where others use the cores)"
    parser.add_argument("--threads", type=int, default=1, metavar="N", help=text)
    return parser
