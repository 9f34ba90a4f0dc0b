# SPDX-License-Identifier: GPL-3.0-or-later
"""What the makers of broken files share: the points, and the sentence that many files get."""

from __future__ import annotations

import struct

Point = tuple[float, float, float]

# The corners of a cube: what is broken is the file, never the points.
CORNERS: list[Point] = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]


def floats(points: list[Point]) -> bytes:
    """The points as little-endian float32."""
    return b"".join(struct.pack("<3f", *point) for point in points)


def with_value(value: float, *indices: int) -> list[Point]:
    """The corners, the y coordinates of those named replaced."""
    return [(x, value if i in indices else y, z) for i, (x, y, z) in enumerate(CORNERS)]


def promise(points: int, size: int, content: bytes, room: int) -> str:
    """The sentence for a header that promises more than the file holds."""
    return (
        f"its header promises {points} points of {size} bytes each, but the file, of "
        f"{len(content)} bytes, has room for only {room}: it is truncated, or its header is wrong."
    )
