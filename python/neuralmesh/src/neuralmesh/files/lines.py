# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of numbers, in bounded blocks: PLY, OFF, STL and PCD as text, OBJ, and lists of points."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from .registry import UnreadableFile

LINES = 50_000  # a tenth of a second, after which Ctrl-C is heard
SHOWN = 60  # characters of a line that cannot be read
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?|[-+]?(nan|inf)", re.IGNORECASE)


def rows(
    path: Path, file: BinaryIO, count: int, columns: Sequence[int], what: str
) -> Iterator[NDArray[np.float64]]:
    """Yield some columns of the next `count` lines, in blocks, without empty ones and comments.

    Raises UnreadableFile where there are fewer, or a line lacks a number.
    """
    left = count
    while left > 0:
        block = list(itertools.islice(file, min(left, LINES)))
        if not block:
            raise cut_short(path, count, count - left, what)
        filled = [line for line in block if line.strip() and not line.lstrip().startswith(b"#")]
        left -= len(filled)
        yield numbers(path, filled, columns)


def rows_with_key(path: Path, key: bytes) -> Iterator[tuple[list[bytes], float]]:
    """Yield the lines that begin with the word `key`, in blocks, and the share that is read.

    Blanks before it do not count, nor do small and capital letters.
    """
    size, keys = max(path.stat().st_size, 1), (key + b" ", key + b"\t")
    with path.open("rb") as file:
        while block := list(itertools.islice(file, LINES)):
            begin = len(key) + 1
            found = [line for line in block if line.lstrip()[:begin].lower() in keys]
            yield found, file.tell() / size


def numbers(
    path: Path,
    lines: Sequence[bytes] | Sequence[str],
    columns: Sequence[int],
    separator: str | None = None,
) -> NDArray[np.float64]:
    """Return these columns of lines, (lines, columns); raises UnreadableFile."""
    if not lines:
        return np.empty((0, len(columns)))
    try:
        return np.loadtxt(lines, delimiter=separator, usecols=columns, comments=None, ndmin=2)
    except ValueError as error:
        raise _of_first_broken(path, _as_text(lines), columns, separator) from error


def has_numbers(line: str, columns: Sequence[int], separator: str | None = None) -> bool:
    """Return whether a line has a number in each of these columns."""
    fields = [field.strip() for field in line.split(separator)]
    return max(columns) < len(fields) and all(NUMBER.fullmatch(fields[c]) for c in columns)


def cut_short(path: Path, promised: int, held: int, what: str) -> UnreadableFile:
    """Return the error of a file whose header promises more than it holds."""
    return UnreadableFile(
        path, f"it is cut short: its header promises {promised:,} {what}, but it holds {held:,}."
    )


def none_of_points(path: Path, line: str) -> UnreadableFile:
    """Return the error of a line that is broken; the last one has no end where it is cut."""
    shown = line.strip()[:SHOWN]
    if line.endswith(("\n", "\r")):
        return UnreadableFile(path, f"this line is none of points: '{shown}'.")
    return UnreadableFile(path, f"it is cut short, or its last line is none of points: '{shown}'.")


def _of_first_broken(
    path: Path, lines: Iterable[str], columns: Sequence[int], separator: str | None
) -> UnreadableFile:
    broken = (line for line in lines if line.strip() and not has_numbers(line, columns, separator))
    return none_of_points(path, next(broken, "\n"))


def _as_text(lines: Sequence[bytes] | Sequence[str]) -> Iterator[str]:
    return (line if isinstance(line, str) else line.decode("latin-1") for line in lines)
