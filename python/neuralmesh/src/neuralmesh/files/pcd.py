# SPDX-License-Identifier: GPL-3.0-or-later
"""PCD, the format of the Point Cloud Library: ascii, binary and binary_compressed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from .. import _core
from .cloud import Chunk
from .lines import cut_short, rows
from .registry import UnreadableFile

POINTS = 1_000_000
LONGEST_HEADER = 64  # lines
TYPES = {(kind, size) for kind in "IU" for size in (1, 2, 4, 8)} | {("F", 4), ("F", 8)}
Entries = dict[str, list[str]]


@dataclass
class Header:
    """Fields, their places in a record, and how many records follow."""

    record: np.dtype[Any]
    count: int
    encoding: str


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the points; those that are not finite, which stand for no return, are left out.

    The older name of FIELDS is COLUMNS.
    """
    with path.open("rb") as file:
        header = _header(path, file)
        if not {"x", "y", "z"} <= set(_names(header.record)):
            raise UnreadableFile(path, "its points have no x, y and z.")
        readers = {"ascii": _text, "binary": _binary, "binary_compressed": _compressed}
        if header.encoding not in readers:
            raise UnreadableFile(path, f"its DATA is of the unknown kind '{header.encoding}'.")
        read = 0
        for records in readers[header.encoding](path, file, header):
            read += len(records)
            yield _chunk(records, read / max(header.count, 1))


def _header(path: Path, file: BinaryIO) -> Header:
    entries: Entries = {}
    for _ in range(LONGEST_HEADER):
        line = file.readline(4096).decode("latin-1").strip()
        if not line or line.startswith("#"):
            continue
        key, *values = line.split()
        entries[key] = values
        if key == "DATA":
            break
    else:
        raise UnreadableFile(path, "it has no header of a PCD file.")
    record = _record(path, entries)
    if "POINTS" in entries:
        count = _whole(path, entries, "POINTS")[0]
    else:
        height = _whole(path, entries, "HEIGHT")[0] if "HEIGHT" in entries else 1
        count = _whole(path, entries, "WIDTH")[0] * height
    return Header(record, count, _entry(path, entries, "DATA")[0])


def _record(path: Path, entries: Entries) -> np.dtype[Any]:
    names = _entry(path, entries, "COLUMNS" if "COLUMNS" in entries else "FIELDS")
    sizes, types = _whole(path, entries, "SIZE"), _entry(path, entries, "TYPE")
    counts = _whole(path, entries, "COUNT") if "COUNT" in entries else [1] * len(names)
    if not len(names) == len(sizes) == len(types) == len(counts):
        raise UnreadableFile(path, "its header has more fields in one line than in another.")
    fields: list[Any] = []
    for number, (name, size, kind, many) in enumerate(
        zip(names, sizes, types, counts, strict=True)
    ):
        if (kind, size) not in TYPES:
            raise UnreadableFile(path, f"its field {name} is of the unknown type {kind} {size}.")
        label = f"unused{number}" if name == "_" else name
        fields.append((label, f"<{kind.lower()}{size}", (many,) if many != 1 else ()))
    return np.dtype(fields)


def _entry(path: Path, entries: Entries, key: str) -> list[str]:
    if not entries.get(key):
        raise UnreadableFile(path, f"its header has no line {key}.")
    return entries[key]


def _whole(path: Path, entries: Entries, key: str) -> list[int]:
    words = _entry(path, entries, key)
    if not all(word.isdecimal() for word in words):
        raise UnreadableFile(path, f"its header has a line {key} of other than whole numbers.")
    return list(map(int, words))


def _text(path: Path, file: BinaryIO, header: Header) -> Iterator[NDArray[Any]]:
    places, columns = {}, 0
    for name in _names(header.record):
        places[name] = columns
        columns += int(np.prod(header.record[name].shape, dtype=int))
    names = [name for name in ("x", "y", "z", "rgb", "rgba") if name in places]
    for values in rows(path, file, header.count, [places[name] for name in names], "points"):
        records = np.zeros(len(values), header.record)
        for name, column in zip(names, values.T, strict=True):
            records[name] = column
        yield records


def _binary(path: Path, file: BinaryIO, header: Header) -> Iterator[NDArray[Any]]:
    size = header.record.itemsize
    held = (path.stat().st_size - file.tell()) // max(size, 1)
    if held < header.count:
        raise cut_short(path, header.count, held, "points")
    for begin in range(0, header.count, POINTS):
        yield np.fromfile(file, header.record, count=min(header.count - begin, POINTS))


def _compressed(path: Path, file: BinaryIO, header: Header) -> Iterator[NDArray[Any]]:
    """One block by LZF, in which all values of a field stand together."""
    sizes = file.read(8)
    if len(sizes) < 8:
        raise cut_short(path, header.count, 0, "points")
    packed_size, size = np.frombuffer(sizes, "<u4")
    if int(size) != header.count * header.record.itemsize:
        raise UnreadableFile(path, "its block is not as long as its header says.")
    packed = file.read(int(packed_size))
    if len(packed) < packed_size:
        raise cut_short(path, int(packed_size), len(packed), "bytes of packed points")
    block = _core.lzf_decompressed(packed, int(size))
    records, begin = np.empty(header.count, header.record), 0
    for name in _names(header.record):
        kind = header.record[name]
        values = np.frombuffer(block, kind, count=header.count, offset=begin)
        records[name] = values
        begin += header.count * kind.itemsize
    yield records


def _chunk(records: NDArray[Any], done: float) -> Chunk:
    points = np.column_stack([records[axis].astype(np.float64) for axis in "xyz"])
    finite = np.isfinite(points).all(axis=1)
    packed = next((records[n] for n in ("rgb", "rgba") if n in _names(records.dtype)), None)
    colours = None
    if packed is not None and packed.dtype.itemsize == 4:
        bits = np.ascontiguousarray(packed).view(np.uint32)  # also where its type is float
        colours = np.column_stack([bits >> shift & 255 for shift in (16, 8, 0)]).astype(np.uint8)
        colours = colours[finite]
    return Chunk(points[finite], colours, done, int((~finite).sum()))


def _names(record: np.dtype[Any]) -> tuple[str, ...]:
    return record.names or ()
