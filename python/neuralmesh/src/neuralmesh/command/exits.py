# SPDX-License-Identifier: GPL-3.0-or-later
"""Exit codes, and what is said beside the output."""

from __future__ import annotations

import sys

from neuralmesh_tools.batching.left_out import LeftOut, left_out_text

from ..files import Folder

DONE = 0
REFUSED = 1  # an input, a parameter or an output cannot be used; a sentence says why
# 2: the command line is wrong; argparse says how
INTERRUPTED = 130  # as shells have it for Ctrl-C


def say(sentence: str) -> None:
    """Tell the user on standard error."""
    print(f"neuralmesh: {sentence}", file=sys.stderr, flush=True)


def say_what_is_left_out(folder: Folder) -> None:
    """Name and count what a folder holds besides the files that are read."""
    if left_out := left_out_text([LeftOut(path, kind) for path, kind in folder.left_out]):
        say(f"'{folder.left_out[0][0].parent}': {left_out[0].lower()}{left_out[1:]}")


def sentence(error: Exception) -> str:
    """Return what to tell of an error."""
    if isinstance(error, OSError) and error.filename is not None:
        return f"'{error.filename}': {error.strerror}."
    if isinstance(error, MemoryError):
        return str(error) or "Too little memory."
    return str(error)
