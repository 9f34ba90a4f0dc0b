# SPDX-License-Identifier: GPL-3.0-or-later
"""What is known of a constant besides its value and its comment, and the shapes for sweeps."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

BODIES = ("hand", "bracket", "radiator-0.5", "raspberry-0.5")
WALLS = ("plate", "radiator", "hand")
EDGES = ("bowl", "bowl-0.5")
LEARNED = ("learned-hand", "learned-bracket", "learned-radiator-0.5", "learned-raspberry-0.5")
SCANS = ("scan-of-hand", "scan-of-bracket")
SPARSE = ("sparse-hand", "hand")
NOISE = ("hand-0.3", "radiator-0.5", "raspberry-0.5")
OUTLIERS = ("outliers", "hand", "radiator-0.5")
IMPLICIT = ("implicit-plate",)
PARAMETRIC = ("parametric-ball",)


@dataclass(frozen=True)
class Entry:
    """What is known of a constant besides its value and the source's comment."""

    unit: str
    half: str = ""
    """The value at half; empty: not swept."""
    double: str = ""
    source: str = ""
    """Paper, command or derivation; empty: the source's comment says it."""
    shapes: tuple[str, ...] = BODIES

    @property
    def is_swept(self) -> bool:
        """Whether half and double are measured."""
        return bool(self.half)


Key = tuple[str, str]


def swept(file: str, shapes: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> dict[Key, Entry]:
    """Rows: name, half, double, unit and, where the comment does not say it, the source."""
    return {
        (file, name): Entry(unit, half, double, " ".join(source), shapes)
        for name, half, double, unit, *source in rows
    }


def fixed(file: str, rows: Iterable[tuple[str, str, str]]) -> dict[Key, Entry]:
    """Rows: name, unit and why it is not swept."""
    return {(file, name): Entry(unit, source=source) for name, unit, source in rows}
