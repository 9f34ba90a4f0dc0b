# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that several programs have, each understood in one way."""

from __future__ import annotations

import argparse
from collections.abc import Collection, Iterable
from pathlib import Path

from neuralmesh_tools.project import PLUGIN


def parser_of(description: str | None) -> argparse.ArgumentParser:
    """A parser that prints the description as it is written."""
    return argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawDescriptionHelpFormatter
    )


def add_plugin(parser: argparse._ActionsContainer) -> None:
    """Add --plugin FILE, by default the one that scripts/build made."""
    parser.add_argument(
        "--plugin", type=Path, default=PLUGIN, metavar="FILE", help="the built plugin"
    )


def names(
    parser: argparse.ArgumentParser, kind: str, text: str, known: Collection[str]
) -> list[str]:
    """Split a comma-separated list of known names; exits with 2 on one that is not. all: all."""
    if text == "all":
        return list(known)
    given = [name for name in text.split(",") if name]
    for name in given:
        if name not in known:
            parser.error(f"there is no {kind} {name}; there are {listed(known)}")
    return given


def listed(words: Iterable[str]) -> str:
    """The words, separated by commas."""
    return ", ".join(words)
