# SPDX-License-Identifier: GPL-3.0-or-later
"""What a shared library says of itself in its dynamic section, by readelf."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

# The C and C++ run-time libraries of any Linux. MeshLab's and Qt's are the host's own.
RUNTIME = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "ld-linux-x86-64.so.2"}

HOST = "libmeshlab-common.so"


def needed(library: Path) -> set[str]:
    """Return the names of the libraries that it cannot be loaded without."""
    return set(re.findall(r"\(NEEDED\).*\[(.*)\]", _dynamic_section(library)))


def has_search_path(library: Path) -> bool:
    """Return whether it looks for libraries in folders of the machine that built it."""
    return bool(re.search(r"\((RUNPATH|RPATH)\)", _dynamic_section(library)))


def _dynamic_section(library: Path) -> str:
    command = ["readelf", "--dynamic", "--wide", str(library)]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout
