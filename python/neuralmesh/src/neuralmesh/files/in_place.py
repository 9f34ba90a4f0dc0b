# SPDX-License-Identifier: GPL-3.0-or-later
"""Which files the core maps into memory and reads where they lie, by their headers.

Where a header is broken, or of another format than the ending says, the core is asked, too: it goes
by the content, and says what is wrong.
"""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

import numpy as np

from .ply_header import read_header

# Of LAS: where things are in the header, and up to what the core knows.
LAS_VERSION, LAS_OFFSET, LAS_FORMAT, LAS_HEADER = 24, 96, 104, 227
LAS_MINOR, LAS_FORMATS = 4, 10
LONGEST_RECORDS = 1_000_000  # bytes, between the header of LAS and its points


def is_read_in_place(path: Path) -> bool:
    """Return whether the core can sample the file itself, without the points in memory.

    PLY, binary, with float or double coordinates and no list before or in its vertices; LAS that is
    not compressed; NPY of (N, 3) float32 or float64 in C order.
    """
    look = {".ply": _ply, ".las": _las, ".npy": _npy}.get(path.suffix.lower())
    if look is None:
        return False
    try:
        with path.open("rb") as file:
            return look(file)
    except (OSError, ValueError):
        return True


def _ply(file: BinaryIO) -> bool:
    header = read_header(file)
    if header is None:
        return True
    record = header.record
    names = (record.names or ()) if record is not None else ()
    return record is not None and all(axis in names and record[axis].kind == "f" for axis in "xyz")


def _las(file: BinaryIO) -> bool:
    head = file.read(LAS_HEADER)
    if not head.startswith(b"LASF") or len(head) < LAS_HEADER:
        return True
    begin = int.from_bytes(head[LAS_OFFSET : LAS_OFFSET + 4], "little")
    records = file.read(min(begin, LONGEST_RECORDS))
    is_known = head[LAS_VERSION + 1] <= LAS_MINOR and head[LAS_FORMAT] <= LAS_FORMATS
    return is_known and b"laszip encoded\0" not in records


def _npy(file: BinaryIO) -> bool:
    if np.lib.format.read_magic(file) == (1, 0):
        shape, is_by_columns, kind = np.lib.format.read_array_header_1_0(file)
    else:
        shape, is_by_columns, kind = np.lib.format.read_array_header_2_0(file)
    is_table = len(shape) == 2 and shape[1] == 3 and not is_by_columns
    return is_table and kind.kind == "f" and kind.itemsize in (4, 8)
