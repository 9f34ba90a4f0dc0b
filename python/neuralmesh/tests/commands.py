# SPDX-License-Identifier: GPL-3.0-or-later
"""The installed command, as a process of its own."""

from __future__ import annotations

import subprocess
import sys


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run `python -m neuralmesh` with the arguments, and keep what it prints."""
    return subprocess.run(
        [sys.executable, "-m", "neuralmesh", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
