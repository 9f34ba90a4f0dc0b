# SPDX-License-Identifier: GPL-3.0-or-later
"""LAS, LAZ and COPC, by laspy and lazrs, in chunks."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import laspy
import numpy as np

from .cloud import Chunk

POINTS = 200_000  # a tenth of a second of LAZ, after which Ctrl-C is heard


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the points of a file, withheld ones too."""
    with laspy.open(path) as file:
        total = max(file.header.point_count, 1)
        has_colours = "red" in file.header.point_format.dimension_names
        divisor, read = None, 0
        for records in file.chunk_iterator(POINTS):
            points = np.column_stack([records.x, records.y, records.z])
            colours = None
            if has_colours:
                wide = np.column_stack([records.red, records.green, records.blue])
                # 16 bits by the standard, 8 bits by the habit of some programs.
                divisor = divisor or (256 if wide.max(initial=0) > 255 else 1)
                colours = np.minimum(wide // divisor, 255).astype(np.uint8)
            read += len(points)
            yield Chunk(points, colours, read / total)
