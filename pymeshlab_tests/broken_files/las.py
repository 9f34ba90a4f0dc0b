# SPDX-License-Identifier: GPL-3.0-or-later
"""Broken LAS files, and compressed ones (LAZ)."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator

from broken_files.common import CORNERS, promise

LAZ = (
    "its points are compressed (LAZ), so that none can be read in place. Decompress it to LAS "
    "first, for instance with PDAL: pdal translate in.laz out.las"
)


def las(minor: int = 2, points: int = 8, **changes: tuple[str, object]) -> bytes:
    """A LAS file of the cube's corners, scale 0.01; changes are (struct format, value) at _OFFSET.

    minor: 2 with point format 0, or 4 with point format 6.
    """
    size, form, length = {2: (227, 0, 20), 4: (375, 6, 30)}[minor]
    header = bytearray(size)
    struct.pack_into("<4s", header, 0, b"LASF")
    struct.pack_into("<BB", header, 24, 1, minor)
    struct.pack_into("<HI", header, 94, size, size)
    struct.pack_into("<BHI", header, 104, form, length, points if minor == 2 else 0)
    struct.pack_into("<3d", header, 131, 0.01, 0.01, 0.01)
    struct.pack_into("<6d", header, 179, 1, 0, 1, 0, 1, 0)
    if minor == 4:
        struct.pack_into("<Q", header, 247, points)
    body = b"".join(
        struct.pack("<3i", *(round(100 * each) for each in point)).ljust(length, b"\0")
        for point in CORNERS
    )
    content = header + body
    for place, (kind, value) in changes.items():
        struct.pack_into("<" + kind, content, int(place[1:]), value)
    return bytes(content)


def headers() -> Iterator[tuple[str, bytes, str]]:
    """Versions, formats and sizes that cannot be."""
    yield "magic only", b"LASF", "its LAS header is truncated: the file ends after 4 bytes."
    yield (
        "cut in the header",
        las()[:226],
        "its LAS header is truncated: the file ends after 226 bytes.",
    )
    yield (
        "cut in the header of 1.4",
        las(4)[:300],
        "its LAS header of 375 bytes is truncated: the file ends after 300.",
    )
    yield (
        "version 2.0",
        las(_24=("H", 2)),
        "it is of LAS version 2.0; versions up to 1.4 are read.",
    )
    yield (
        "version 1.5",
        las(_25=("B", 5)),
        "it is of LAS version 1.5; versions up to 1.4 are read.",
    )
    yield (
        "header too short",
        las(_94=("H", 226)),
        "its LAS header says that it is 226 bytes long, but version 1.2 needs 227.",
    )
    yield (
        "1.4 with the header of 1.2",
        las(_25=("B", 4)),
        "its LAS header says that it is 227 bytes long, but version 1.4 needs 375.",
    )
    yield (
        "points inside the header",
        las(_96=("I", 100)),
        "its points start at byte 100, inside the header of 227 bytes.",
    )
    yield (
        "unknown point format",
        las(_104=("B", 11)),
        "it is of LAS point format 11; formats 0 to 10 are read.",
    )
    yield (
        "points too short",
        las(_105=("H", 19)),
        "its points are 19 bytes long, but LAS point format 0 needs 20.",
    )
    yield (
        "points of no length",
        las(4, _105=("H", 0)),
        "its points are 0 bytes long, but LAS point format 6 needs 30.",
    )


def counts() -> Iterator[tuple[str, bytes, str]]:
    """Counts that are wrong, and files shorter than their counts."""
    yield "no points", las(points=0), "it holds no points."
    yield "no points in 1.4", las(4, points=0), "it holds no points."
    yield "huge count", las(points=2**32 - 1), promise(2**32 - 1, 20, las(), 8)
    for name, count in (("huge count in 1.4", 2**64 - 1), ("overflow in 1.4", 2**64 // 30 + 1)):
        yield name, las(4, points=count), promise(count, 30, las(4), 8)
    yield "truncated", las()[:-1], promise(8, 20, las()[:-1], 7)
    far = las(_96=("I", 2**32 - 1))
    yield "points beyond the end", far, promise(8, 20, far, 0)
    longer = las(_105=("H", 65535))
    yield "points longer than the file", longer, promise(8, 65535, longer, 0)


def coordinates() -> Iterator[tuple[str, bytes, str]]:
    """Scales and offsets that give no coordinates."""
    for name, value in (("zero", 0.0), ("NaN", math.nan), ("infinite", math.inf), ("negative", -1)):
        yield (
            f"scale {name}",
            las(_139=("d", value)),
            "the scale of its coordinate y is not a positive finite number.",
        )
    for name, value in (("NaN", math.nan), ("infinite", -math.inf)):
        yield (
            f"offset {name}",
            las(_171=("d", value)),
            "the offset of its coordinate z is not finite, or too large.",
        )
    yield (
        "scale beyond all bounds",
        las(_131=("d", 1e305)),
        "the offset of its coordinate x is not finite, or too large.",
    )


def compressed() -> Iterator[tuple[str, bytes, str]]:
    """LAZ, by each of its signs."""
    yield "LAZ by its highest bit", las(_104=("B", 128)), LAZ
    yield "LAZ by the second highest bit", las(4, _104=("B", 0x46)), LAZ
    record = struct.pack("<H16sHH32s", 0, b"laszip encoded", 22204, 0, b"")
    plain = las(_96=("I", 227 + 54), _100=("I", 1))
    yield "LAZ by its record", plain[:227] + record + plain[227:], LAZ
