# SPDX-License-Identifier: GPL-3.0-or-later
"""Points as text: XYZ and its kin, comma-separated values with or without a header, Leica's PTS.

Columns are those that a header names. Without one they are x, y, z; then, of six, colours where all
are whole numbers up to 255, normals otherwise; of seven (PTS), intensity and colours.
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
from .registry import UnreadableFile
from .text_header import Columns, Header

LINES = 100_000  # a tenth of a second, after which Ctrl-C is heard
COMMENTS = ("#", "//", "!")
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?|[-+]?(nan|inf)", re.IGNORECASE)


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the points of a text file."""
    size = max(path.stat().st_size, 1)
    with path.open(encoding="utf-8-sig", errors="strict", newline=None) as file:
        try:
            yield from _parse(path, file, size)
        except UnicodeDecodeError:
            raise UnreadableFile(path, "it is not text.") from None


def begins_with_points(path: Path) -> bool:
    """Return whether a file has points, or a header of points, before any other text."""
    with path.open(encoding="utf-8-sig", errors="replace") as file:
        try:
            return _first_points(path, file, Header())[0] is not None
        except UnreadableFile:
            return False


def _parse(path: Path, file: TextIO, size: int) -> Iterator[Chunk]:
    header = Header()
    first, promised = _first_points(path, file, header)
    if first is None:
        return
    separator, decimal_comma = _separator(first)
    count = len(_fields(first, separator))
    columns = _columns(path, header, first, separator)
    lines = itertools.chain([first], file)
    read, found = 0, 0
    while block := list(itertools.islice(lines, LINES)):
        read += sum(map(len, block))
        if decimal_comma:
            block = [line.replace(",", ".") for line in block]
        if columns.colours == ():
            columns.colours = _guess_colours(block, separator, count)
        numbers, more_promised = _numbers(path, block, separator, columns)
        promised += more_promised
        found += len(numbers)
        colours = None
        if columns.colours:
            colours = _as_bytes(numbers[:, 3:6])
        yield Chunk(np.ascontiguousarray(numbers[:, :3]), colours, min(1.0, read / size))
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
        words = re.split(r"[\s,;]+", text.strip(" ,;"))
        if not NUMBER.fullmatch(words[0].replace('"', "")):
            header.add_line(path, line.rstrip("\r\n"))
        elif len(words) == 1:  # PTS: how many points follow
            promised += _promised(text)
        else:
            return line, promised
    return None, promised


def _promised(text: str) -> int:
    return int(text) if text.isdecimal() else 0


def _separator(line: str) -> tuple[str | None, bool]:
    """What parts the fields, None for white space, and whether decimals have a comma."""
    if ";" in line:
        return ";", "," in line
    if "," in line:
        return ",", False
    return ("\t", False) if "\t" in line.strip() else (None, False)


def _fields(line: str, separator: str | None) -> list[str]:
    return [field.strip() for field in line.strip().rstrip(",;").split(separator)]


def _columns(path: Path, header: Header, first: str, separator: str | None) -> Columns:
    count = len(_fields(first, separator))
    if count < 3:
        raise UnreadableFile(path, "its lines have fewer than three numbers.")
    counts = (count, len(first.rstrip("\r\n").split(separator)))
    found = header.columns(path, counts, separator)
    return found or Columns((0, 1, 2), () if count >= 6 else None)


def _guess_colours(block: list[str], separator: str | None, count: int) -> tuple[int, ...] | None:
    """The three columns after x, y, z or, of seven and more, after the intensity, if of colours."""
    place = (3, 4, 5) if count == 6 else (4, 5, 6)
    values = []
    for line in block[:1000]:
        fields = _fields(line, separator)
        if len(fields) == count:
            values.append([fields[column] for column in place])
    is_colour = all(re.fullmatch(r"\d{1,3}", word) for row in values for word in row)
    return place if values and is_colour else None


def _numbers(
    path: Path, block: list[str], separator: str | None, columns: Columns
) -> tuple[NDArray[np.float64], int]:
    """The numbers of the lines, and how many points lines between them promise."""
    try:
        return _loaded(block, separator, columns), 0
    except ValueError:
        # Some line is none of points: counts of further scans, comments, or what is broken.
        lines, promised = _lines_of_points(path, block, separator, columns)
        return _loaded(lines, separator, columns), promised


def _loaded(block: list[str], separator: str | None, columns: Columns) -> NDArray[np.float64]:
    if not block:
        return np.empty((0, len(columns.used)))
    return np.loadtxt(block, delimiter=separator, usecols=columns.used, comments=None, ndmin=2)


def _lines_of_points(
    path: Path, block: list[str], separator: str | None, columns: Columns
) -> tuple[list[str], int]:
    kept, promised = [], 0
    for line in block:
        text = line.strip()
        fields = _fields(line, separator)
        if not text or text.startswith(COMMENTS):
            continue
        if len(fields) == 1 and text.isdecimal():
            promised += _promised(text)
            continue
        words = [fields[column] for column in columns.used if column < len(fields)]
        if len(words) < len(columns.used) or not all(map(NUMBER.fullmatch, words)):
            raise UnreadableFile(path, f"this line is none of points: '{text[:60]}'.")
        kept.append(line)
    return kept, promised


def _as_bytes(colours: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Shares of 1 become numbers up to 255, numbers of 16 bits their upper half."""
    most = colours.max(initial=0)
    if 0 < most <= 1 and (colours != np.floor(colours)).any():
        colours = np.rint(255 * colours)
    elif most > 255:
        colours = colours // 256
    return np.clip(colours, 0, 255).astype(np.uint8)
