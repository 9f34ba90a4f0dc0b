# SPDX-License-Identifier: GPL-3.0-or-later
"""PLY, binary and text: vertices of a binary file are mapped, not loaded; others by plyfile.

Faces, which follow, are never read.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray
from plyfile import PlyData

from .cloud import Chunk
from .ply_header import Header, read_header
from .registry import UnreadableFile

POINTS = 1_000_000
COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"))


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices."""
    vertices = _vertices(path)
    names = vertices.dtype.names or ()
    if not {"x", "y", "z"} <= set(names):
        raise UnreadableFile(path, "its vertices have no x, y and z.")
    colour_names = next((c for c in COLOURS if set(c) <= set(names)), None)
    for begin in range(0, len(vertices), POINTS):
        part = vertices[begin : begin + POINTS]
        points = np.column_stack([part[axis].astype(np.float64) for axis in "xyz"])
        colours = None
        if colour_names is not None:
            colours = np.column_stack([_as_bytes(part[name]) for name in colour_names])
        yield Chunk(points, colours, min(1.0, (begin + POINTS) / max(len(vertices), 1)))


def _vertices(path: Path) -> NDArray[Any]:
    """The records of the vertices."""
    with path.open("rb") as file:
        header = read_header(file)
        if header is not None and header.record is not None:
            return _mapped(path, header, header.record, file.tell())
        if header is not None:
            # What follows the vertices is not promised any more, so that it is not read.
            joined = io.BufferedReader(_Joined(header.lines, file))
            return PlyData.read(joined)["vertex"].data
    ply = PlyData.read(str(path), mmap="c")
    if "vertex" not in ply:
        raise UnreadableFile(path, "it has no vertices.")
    return ply["vertex"].data


def _mapped(path: Path, header: Header, record: np.dtype[Any], begin: int) -> NDArray[Any]:
    count, begin = header.vertices.count, begin + header.bytes_before
    held = max(path.stat().st_size - begin, 0) // max(record.itemsize, 1)
    if held < count:
        raise UnreadableFile(
            path, f"it is cut short: its header promises {count:,} vertices, but it holds {held:,}."
        )
    if count == 0:
        return np.empty(0, record)
    return np.memmap(path, record, "r", begin, (count,))


class _Joined(io.RawIOBase):
    """Bytes, and after them the rest of a file."""

    def __init__(self, first: bytes, file: BinaryIO) -> None:
        self._first, self._file = first, file

    def readable(self) -> bool:
        """Return that it is."""
        return True

    def readinto(self, buffer: Any) -> int:
        """Fill the buffer as far as there is something."""
        part = self._first[: len(buffer)] or self._file.read(len(buffer))
        self._first = self._first[len(part) :]
        buffer[: len(part)] = part
        return len(part)


def _as_bytes(values: np.ndarray) -> np.ndarray:
    if values.dtype.kind == "f":
        values = np.rint(255 * values)
    elif values.dtype.itemsize == 2:
        values = values // 256
    return np.clip(values, 0, 255).astype(np.uint8)
