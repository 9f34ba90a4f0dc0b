# SPDX-License-Identifier: GPL-3.0-or-later
"""LAS, LAZ and COPC, by laspy and lazrs, in chunks."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import laspy
import numpy as np

from .cloud import Chunk
from .lines import cut_short
from .registry import UnreadableFile

POINTS = 200_000  # a tenth of a second of LAZ, after which Ctrl-C is heard


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the points of a file, withheld ones too; raises UnreadableFile if it is cut short."""
    with laspy.open(path, read_evlrs=False) as file:
        total = file.header.point_count
        _require_room(path, file.header)
        has_colours = "red" in file.header.point_format.dimension_names
        divisor, read = None, 0
        for records in _records(path, file):
            points = np.column_stack([records.x, records.y, records.z])
            colours = None
            if has_colours:
                wide = np.column_stack([records.red, records.green, records.blue])
                # 16 bits by the standard, 8 bits by the habit of some programs.
                divisor = divisor or (256 if wide.max(initial=0) > 255 else 1)
                colours = np.minimum(wide // divisor, 255).astype(np.uint8)
            read += len(points)
            yield Chunk(points, colours, read / total)


def _require_room(path: Path, header: Any) -> None:
    """Refuse a file that is shorter than its points: laspy would leave out the last ones."""
    if header.are_points_compressed:
        return
    size = path.stat().st_size - header.offset_to_point_data
    room = max(size, 0) // header.point_format.size
    if room < header.point_count:
        raise cut_short(path, header.point_count, room, "points")


def _records(path: Path, file: Any) -> Iterator[Any]:
    """The records by pieces; of compressed ones, it shows only then that some are missing."""
    read, total = 0, file.header.point_count
    try:
        for records in file.chunk_iterator(POINTS):
            read += len(records)
            yield records
    except (OSError, MemoryError):
        raise
    except Exception as error:  # lazrs has its own
        raise _broken(path, total, read) from error
    if read < total:
        raise _broken(path, total, read)


def _broken(path: Path, promised: int, read: int) -> UnreadableFile:
    return UnreadableFile(
        path,
        f"it is cut short or broken: its header promises {promised:,} points, of which {read:,} "
        "could be read.",
    )
