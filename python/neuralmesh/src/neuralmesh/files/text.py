# SPDX-License-Identifier: GPL-3.0-or-later
"""Points as text: XYZ and its kin, comma-separated values with or without a header, Leica's PTS.

Columns are those that a header names. Without one they are x, y, z; then colours, where three whole
numbers from 0 to 255 come at once or behind one of another kind, the intensity. Numbers that are
never above 1 are normals.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

from .cloud import Chunk
from .lines import LINES, NUMBER, numbers
from .registry import UnreadableFile
from .text_dialect import Dialect, dialect_of, opened, require_unambiguous
from .text_header import Columns, Header

COMMENTS = ("#", "//", "!")


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the points of a text file."""
    size = max(path.stat().st_size, 1)
    with opened(path) as file:
        yield from _parse(path, file, size)


def begins_with_points(path: Path) -> bool:
    """Return whether a file has points, or a header of points, before any other text."""
    try:
        with opened(path) as file:
            return _first_points(path, file, Header())[0] is not None
    except UnreadableFile:
        return False


def _parse(path: Path, file: TextIO, size: int) -> Iterator[Chunk]:
    header = Header()
    first, promised = _first_points(path, file, header)
    if first is None:
        return
    dialect = dialect_of(first)
    lines = itertools.chain([first], file)
    columns, found = None, 0
    while block := list(itertools.islice(lines, LINES)):
        plain = dialect.plain(path, block)
        if columns is None:
            columns = _columns(path, header, plain, dialect)
        values, more_promised = _values(path, plain, dialect.separator, columns.used)
        promised += more_promised
        found += len(values)
        colours = _as_bytes(values[:, 3:6]) if columns.colours else None
        done = min(1.0, file.buffer.tell() / size)
        yield Chunk(np.ascontiguousarray(values[:, :3]), colours, done)
    if found < promised:
        raise UnreadableFile(path, f"it is cut short: of {promised:,} points it holds {found:,}.")


def _first_points(path: Path, file: TextIO, header: Header) -> tuple[str | None, int]:
    """The first line of points, and how many a line before it promises; fills the header."""
    promised = 0
    for line in file:
        text = line.strip()
        if not text:
            continue
        if text.startswith(COMMENTS):
            header.add_comment(text.lstrip("#/! \t"))
            continue
        words = re.split(r"[\s,;]+", text.replace('"', " ").strip(" ,;"))
        if not NUMBER.fullmatch(re.sub("[dD]", "e", words[0])):
            header.add_line(path, line.rstrip("\r\n"))
        elif len(words) == 1:  # PTS: how many points follow
            promised += _promised(text)
        else:
            return line, promised
    return None, promised


def _promised(text: str) -> int:
    return int(text) if text.isdecimal() else 0


def _columns(path: Path, header: Header, block: list[str], dialect: Dialect) -> Columns:
    """What the header says; without one, by the numbers of the first block."""
    first, separator = block[0], dialect.separator
    count = len(dialect.fields(first))
    if count < 3:
        shown = first.strip()[:60]
        raise UnreadableFile(path, f"its lines have fewer than three numbers, as '{shown}' has.")
    counts = (count, len(first.rstrip("\r\n").split(separator)))
    if found := header.columns(path, counts, separator):
        return found
    require_unambiguous(path, dialect, block)
    return Columns((0, 1, 2), _colours_by_numbers(path, block, separator, count))


def _colours_by_numbers(
    path: Path, block: list[str], separator: str | None, count: int
) -> tuple[int, ...] | None:
    """The three columns behind x, y, z or behind an intensity, if only these can be colours."""
    places = [(3, 4, 5), (4, 5, 6)] if count > 6 else [(3, 4, 5)]
    if count < 6:
        return None
    if count == 7 and path.suffix.lower() == ".pts":  # which has x y z intensity r g b
        places = [(4, 5, 6)]
    fitting = []
    for place in places:
        try:
            values, _ = _values(path, block, separator, place)
        except UnreadableFile:  # words, or columns that not every line has
            continue
        is_whole = (values == np.floor(values)).all()
        if is_whole and values.min(initial=0) >= 0 and 1 < values.max(initial=0) <= 255:
            fitting.append(place)
    return fitting[0] if len(fitting) == 1 else None


def _values(
    path: Path, block: list[str], separator: str | None, columns: tuple[int, ...]
) -> tuple[NDArray[np.float64], int]:
    """The numbers of the lines, and how many points lines between them promise."""
    try:
        return numbers(path, block, columns, separator), 0
    except UnreadableFile:
        # Some line is none of points: counts of further scans, comments, or what is broken.
        texts = [line.strip() for line in block]
        promised = sum(map(_promised, texts))
        lines = [
            line
            for line, text in zip(block, texts, strict=True)
            if text and not text.startswith(COMMENTS) and not text.isdecimal()
        ]
        return numbers(path, lines, columns, separator), promised


def _as_bytes(colours: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Shares of 1 become numbers up to 255, numbers of 16 bits their upper half."""
    most = colours.max(initial=0)
    if 0 < most <= 1 and (colours != np.floor(colours)).any():
        colours = np.rint(255 * colours)
    elif most > 255:
        colours = colours // 256
    return np.clip(colours, 0, 255).astype(np.uint8)
