# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that several programs have, each understood in one way."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Collection, Iterable
from pathlib import Path

from rich.console import Console

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


def console() -> Console:
    """A console that prints names as they are: `[/]` is no markup in them, `:x:` no picture."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # not where a test has put another stream
            stream.reconfigure(errors="backslashreplace")
    return Console(markup=False, emoji=False, highlight=False)


def positive(text: str) -> float:
    """The type of an option that is a positive, finite number."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not (0 < number < math.inf):
        raise argparse.ArgumentTypeError(f"must be a positive number, not {text!r}")
    return number


def folder(text: str) -> Path:
    """The type of an option that names a folder, which need not be there yet."""
    if not text.strip():
        raise argparse.ArgumentTypeError("is empty: it names no folder. Is a variable not set?")
    return Path(text)


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
