# SPDX-License-Identifier: GPL-3.0-or-later
"""The machine and the versions that a report's figures were measured with."""

from __future__ import annotations

import importlib.metadata
import platform
from typing import Any

import psutil

from neuralmesh_tools import operating_system


def machine() -> dict[str, Any]:
    """This machine: system, processor, cores, memory, Python."""
    return {
        "system": platform.platform(),
        "processor": operating_system.processor() or platform.processor() or platform.machine(),
        "cores": psutil.cpu_count(),
        "memory_gigabytes": round(psutil.virtual_memory().total / 2**30, 1),
        "python": platform.python_version(),
    }


def version_of(package: str) -> str:
    """The version of a Python package that is installed."""
    return importlib.metadata.version(package)
