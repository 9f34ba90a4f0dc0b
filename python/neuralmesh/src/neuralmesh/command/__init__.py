# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `neuralmesh`: files in, a mesh out, and its subcommands."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence

from . import reconstruction
from .exits import DONE, INTERRUPTED, REFUSED, say, sentence

# The modules that run them, which are imported only then.
SUBCOMMANDS = {"info": "information", "batch": "batches", "compare": "comparisons"}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    try:
        if given and given[0] in SUBCOMMANDS:
            module = importlib.import_module(f"{__name__}.{SUBCOMMANDS[given[0]]}")
            return int(module.run(given[1:]))
        return reconstruction.run(given)
    except KeyboardInterrupt:
        say("Interrupted.")
        sys.stdout.flush()
        os._exit(INTERRUPTED)  # at once: the core's thread may need a second to hear of it
    except BrokenPipeError:  # the reader of the output went away, as `head` does
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except (ValueError, TypeError, OSError, MemoryError) as error:
        say(sentence(error))
        return REFUSED
