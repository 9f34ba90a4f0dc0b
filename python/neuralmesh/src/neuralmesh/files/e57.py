# SPDX-License-Identifier: GPL-3.0-or-later
"""E57, by pye57: a scan at a time, each in its place among the others."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pye57

from .cloud import Chunk

COLOURS = ("colorRed", "colorGreen", "colorBlue")


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the valid points of each scan."""
    file = pye57.E57(str(path))
    try:
        for number in range(file.scan_count):
            scan = file.read_scan(number, colors=True, ignore_missing_fields=True, transform=True)
            points = np.column_stack(
                [scan[f"cartesian{axis}"].astype(np.float64) for axis in "XYZ"]
            )
            colours = None
            if all(name in scan for name in COLOURS):
                wide = np.column_stack([scan[name] for name in COLOURS])
                most = wide.max(initial=0)
                scaled = wide * 255 if 0 < most <= 1 else wide // (256 if most > 255 else 1)
                colours = np.clip(scaled, 0, 255).astype(np.uint8)
            invalid = file.get_header(number).point_count - len(points)
            yield Chunk(points, colours, (number + 1) / file.scan_count, invalid)
    finally:
        file.close()
