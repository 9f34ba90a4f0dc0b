# SPDX-License-Identifier: GPL-3.0-or-later
"""The machine and the versions that a report's figures were measured with."""

from __future__ import annotations

import importlib.metadata
import platform
from pathlib import Path
from typing import Any

import psutil


def machine() -> dict[str, Any]:
    """This machine: system, processor, cores, memory, Python."""
    return {
        "system": platform.platform(),
        "processor": _processor(),
        "cores": psutil.cpu_count(),
        "memory_gigabytes": round(psutil.virtual_memory().total / 2**30, 1),
        "python": platform.python_version(),
    }


def version_of(package: str) -> str:
    """The version of a Python package that is installed."""
    return importlib.metadata.version(package)


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(
            line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")
        )
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()
