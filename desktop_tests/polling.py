# SPDX-License-Identifier: GPL-3.0-or-later
"""Waiting for a condition, never for a time."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TypeVar

from gi.repository import GLib

T = TypeVar("T")

# A window can take 20 s to appear on a busy machine; a condition that holds is seen at once.
PATIENCE_SECONDS = 60.0
INTERVAL_SECONDS = 0.05


def wait_for(what: str, found: Callable[[], T], seconds: float = PATIENCE_SECONDS) -> T:
    """Return the first true value of `found`; raise TimeoutError, naming `what`, past the bound.

    A widget that vanishes while it is asked raises GLib.Error, which counts as not found.
    """
    end = time.monotonic() + seconds
    while True:
        try:
            value = found()
        except GLib.Error:
            value = None
        if value:
            return value
        if time.monotonic() > end:
            raise TimeoutError(f"waited {seconds:.0f} s in vain for {what}")
        time.sleep(INTERVAL_SECONDS)
