# SPDX-License-Identifier: GPL-3.0-or-later
"""Exit codes, and what is said beside the output."""

from __future__ import annotations

import sys

DONE = 0
REFUSED = 1  # an input, a parameter or an output cannot be used; a sentence says why
# 2: the command line is wrong; argparse says how
INTERRUPTED = 130  # as shells have it for Ctrl-C


def say(sentence: str) -> None:
    """Tell the user on standard error."""
    print(f"neuralmesh: {sentence}", file=sys.stderr, flush=True)
