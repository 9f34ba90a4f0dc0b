# SPDX-License-Identifier: GPL-3.0-or-later
"""`neuralmesh info INPUT...`: what files hold."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path

from .. import files
from .._progress import bar
from ..files.reading import Description
from .exits import DONE, REFUSED, say, say_what_is_left_out, sentence


def run(arguments: Sequence[str]) -> int:
    """Describe each file; a file that cannot be read is named, and the others are described."""
    parser = argparse.ArgumentParser(
        prog="neuralmesh info",
        description="Say what files of points hold: format, count, extent, colours.",
        epilog="exit    0 all were read; 1 one was not; 2 wrong usage; 130 interrupted",
    )
    parser.add_argument(
        "inputs", nargs="+", type=Path, metavar="INPUT", help="a file, or a folder of files"
    )
    parser.add_argument("--json", action="store_true", help="print a JSON object for each file")
    options = parser.parse_args(arguments)
    codes = [_look_at(path, options.json) for path in options.inputs]
    return max(codes)


def _look_at(path: Path, as_json: bool) -> int:
    """Describe a file, or each of a folder; return the exit code."""
    code = DONE
    try:
        folder = files.look_into(path)
    except (files.UnreadableFile, OSError) as error:
        say(sentence(error))
        return REFUSED
    say_what_is_left_out(folder)
    for file in folder.files:
        try:
            _describe(file, as_json)
        except BrokenPipeError:
            raise
        except (files.UnreadableFile, OSError) as error:
            say(sentence(error))
            code = REFUSED
    return code


def _describe(path: Path, as_json: bool) -> None:
    with bar() as progress:
        found = files.describe(path, progress)
    if as_json:
        print(json.dumps({"file": str(path), **vars(found), "diagonal": found.diagonal}))
    else:
        print(_text(path, found))


def _text(path: Path, found: Description) -> str:
    corner = ["(" + ", ".join(f"{x:.10g}" for x in c) + ")" for c in (found.lower, found.upper)]
    lines = [
        f"{path}: {found.format}, {found.points:,} points",
        f"  from {corner[0]} to {corner[1]}, diagonal {found.diagonal:.6g}",
        f"  colours: {'yes' if found.has_colours else 'no'}; "
        f"read in place by neuralmesh.reconstruct(path): {'yes' if found.in_place else 'no'}",
    ]
    if found.not_finite:
        lines.append(f"  {found.not_finite:,} points have coordinates that are NaN or infinite")
    return "\n".join(lines)
