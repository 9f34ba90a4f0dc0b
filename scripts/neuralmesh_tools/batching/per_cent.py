# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors in per cent of the input's diagonal, beside those in units of the input."""

from __future__ import annotations

from typing import Any


def with_per_cent(figures: dict[str, Any], size: float) -> dict[str, Any]:
    """Add the errors, where there are any, in per cent of the input's diagonal (size)."""
    errors = {
        f"{name}_percent": 100 * figures[name] / size
        for name in ("rms_error", "max_error")
        if name in figures and size > 0
    }
    return {**figures, **errors}
