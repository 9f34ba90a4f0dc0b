# SPDX-License-Identifier: GPL-3.0-or-later
"""PLY: vertices of a binary file are mapped, of text read in blocks; those with lists by plyfile.

Faces, which follow, are never read.
"""

from __future__ import annotations

import io
import itertools
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray
from plyfile import PlyData

from .cloud import Chunk
from .lines import cut_short, rows
from .ply_header import Header, read_header
from .registry import UnreadableFile

POINTS = 1_000_000
COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"))


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices."""
    with path.open("rb") as file:
        header = read_header(file)
        if header is None or header.vertices.has_list or not (header.record or header.is_text):
            blocks = _by_plyfile(path, file, header)
        elif header.record is not None:
            blocks = _mapped(path, header, header.record, file.tell())
        else:
            blocks = _text(path, file, header)
        total = None if header is None else header.vertices.count
        read = 0
        for block in blocks:
            read += len(block)
            yield _chunk(path, block, read / max(total or read, 1))


def _chunk(path: Path, vertices: NDArray[Any], done: float) -> Chunk:
    names = vertices.dtype.names or ()
    _require_coordinates(path, names)
    points = np.column_stack([vertices[axis].astype(np.float64) for axis in "xyz"])
    colour_names = next((c for c in COLOURS if set(c) <= set(names)), None)
    colours = None
    if colour_names is not None:
        colours = np.column_stack([_as_bytes(vertices[name]) for name in colour_names])
    return Chunk(points, colours, done)


def _require_coordinates(path: Path, names: tuple[str, ...]) -> None:
    if not {"x", "y", "z"} <= set(names):
        raise UnreadableFile(path, "its vertices have no x, y and z.")


def _mapped(
    path: Path, header: Header, record: np.dtype[Any], begin: int
) -> Iterator[NDArray[Any]]:
    count, begin = header.vertices.count, begin + header.bytes_before
    held = max(path.stat().st_size - begin, 0) // max(record.itemsize, 1)
    if held < count:
        raise cut_short(path, count, held, "vertices")
    if count == 0:
        return
    vertices = np.memmap(path, record, "r", begin, (count,))
    for first in range(0, count, POINTS):
        yield vertices[first : first + POINTS]


def _text(path: Path, file: BinaryIO, header: Header) -> Iterator[NDArray[Any]]:
    """Vertices and what is before them have a line each."""
    before = sum(element.count for element in header.elements[:-1])
    for _ in itertools.islice(file, before):
        pass
    names = tuple(name for name, _ in header.vertices.fields)
    _require_coordinates(path, names)
    wanted = [name for name in names if name in ("x", "y", "z", *COLOURS[0], *COLOURS[1])]
    columns = [names.index(name) for name in wanted]
    kinds = dict(header.vertices.fields)
    # Coordinates keep their digits, also those of float, which a text may have more of.
    record = np.dtype([(n, "f8" if n in ("x", "y", "z") else kinds[n]) for n in wanted])
    for values in rows(path, file, header.vertices.count, columns, "vertices"):
        block = np.empty(len(values), record)
        for name, column in zip(wanted, values.T, strict=True):
            block[name] = column
        yield block


def _by_plyfile(path: Path, file: BinaryIO, header: Header | None) -> Iterator[NDArray[Any]]:
    """Vertices of which nobody knows where they are without reading all, at once."""
    if header is not None:
        # What follows the vertices is not promised any more, so that it is not read.
        joined = io.BufferedReader(_Joined(header.lines, file))
        yield PlyData.read(joined)["vertex"].data
        return
    ply = PlyData.read(str(path), mmap="c")
    if "vertex" not in ply:
        raise UnreadableFile(path, "it has no vertices.")
    yield ply["vertex"].data


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
