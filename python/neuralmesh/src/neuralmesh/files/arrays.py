# SPDX-License-Identifier: GPL-3.0-or-later
"""NPY and NPZ, in blocks of rows. NPY is mapped; of NPZ, an array by columns is loaded whole."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from .cloud import Chunk
from .lines import cut_short
from .registry import UnreadableFile

POINTS = 200_000  # of NPZ a tenth of a second, after which Ctrl-C is heard
NAMES = ("points", "vertices", "xyz", "positions", "pos")
COLOURS = ("colours", "colors", "rgb")


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the rows of the array; in an NPZ of that called points, or of the only one."""
    if path.suffix.lower() == ".npy":
        yield from _of_npy(path)
    else:
        yield from _of_npz(path)


@dataclass
class Array:
    """What the header of an array says."""

    shape: tuple[int, ...]
    is_by_columns: bool
    kind: np.dtype[Any]

    @property
    def is_table(self) -> bool:
        """Whether it has rows of at least three numbers."""
        return len(self.shape) == 2 and self.shape[1] >= 3 and self.kind.kind in "fiu"


def _header(path: Path, file: IO[bytes]) -> Array:
    try:
        if np.lib.format.read_magic(file) == (1, 0):
            return Array(*np.lib.format.read_array_header_1_0(file))
        return Array(*np.lib.format.read_array_header_2_0(file))
    except ValueError as error:
        raise UnreadableFile(
            path, "it is cut short or broken: its header says nothing of an array."
        ) from error


def _require_table(path: Path, array: Array) -> None:
    if not array.is_table:
        raise UnreadableFile(path, f"it holds {array.kind} of the shape {array.shape}, not N x 3.")


def _of_npy(path: Path) -> Iterator[Chunk]:
    with path.open("rb") as file:
        array, begin = _header(path, file), file.tell()
    _require_table(path, array)
    promised, held = begin + math.prod(array.shape) * array.kind.itemsize, path.stat().st_size
    if held < promised:
        raise cut_short(path, promised, held, "bytes")
    if array.shape[0] == 0:
        return
    order: Any = "F" if array.is_by_columns else "C"
    rows = np.memmap(path, array.kind, "r", begin, array.shape, order)
    for first in range(0, len(rows), POINTS):
        points = np.array(rows[first : first + POINTS, :3], dtype=np.float64, order="C")
        yield Chunk(points, None, (first + len(points)) / len(rows))


def _of_npz(path: Path) -> Iterator[Chunk]:
    if not zipfile.is_zipfile(path):
        raise UnreadableFile(
            path, "it is cut short, or no NPZ: the table that ends it, of its arrays, is missing."
        )
    with zipfile.ZipFile(path) as archive, ExitStack() as stack:
        names = [name.removesuffix(".npy") for name in archive.namelist()]
        file = stack.enter_context(archive.open(_name_of_points(path, names) + ".npy"))
        points = _header(path, file)
        _require_table(path, points)
        colours, named = None, next((name for name in COLOURS if name in names), None)
        if named is not None:
            of_colours = stack.enter_context(archive.open(named + ".npy"))
            array = _header(path, of_colours)
            if array.is_table and array.kind == np.uint8 and array.shape[0] == points.shape[0]:
                colours = _blocks(path, of_colours, array)
        read = 0
        for block in _blocks(path, file, points):
            read += len(block)
            yield Chunk(
                np.array(block[:, :3], dtype=np.float64, order="C"),
                None if colours is None else np.ascontiguousarray(next(colours)[:, :3]),
                read / points.shape[0],
            )


def _blocks(path: Path, file: IO[bytes], array: Array) -> Iterator[NDArray[Any]]:
    """The rows of an array whose header has been read."""
    count, width = array.shape
    size = count if array.is_by_columns else POINTS
    for begin in range(0, count, max(size, 1)):
        rows = min(size, count - begin)
        data = file.read(rows * width * array.kind.itemsize)
        if len(data) < rows * width * array.kind.itemsize:
            held = begin + len(data) // (width * array.kind.itemsize)
            raise cut_short(path, count, held, "points")
        order: Any = "F" if array.is_by_columns else "C"
        yield np.frombuffer(data, array.kind).reshape((rows, width), order=order)


def _name_of_points(path: Path, names: list[str]) -> str:
    for name in NAMES:
        if name in names:
            return name
    if len(names) == 1:
        return names[0]
    raise UnreadableFile(path, f"none of its arrays ({', '.join(names)}) is called points.")
