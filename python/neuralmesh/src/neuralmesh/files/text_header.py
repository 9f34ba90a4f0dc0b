# SPDX-License-Identifier: GPL-3.0-or-later
"""What the header of a text file says of its columns.

Titles may be of several words, in quotes and with a unit: GPS Time, "Points:0", x [m], x_m.
So the header is parted as the points are, or otherwise if only then it has as many columns.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from .registry import UnreadableFile

LONGEST = 10_000  # characters of a header
SEPARATORS = (",", ";", "\t", None)  # None: white space
UNIT_IN_BRACKETS = re.compile(r"[\[(][^\[\]()]*[^\W\d][^\[\]()]*[\])]")
UNIT_AT_END = re.compile(r"[\s_/.-]+(mm?|cm|km|ft|us ?ft|feet|met(re|er)s?)$")

_BEFORE = r"(points?|coords?|coordinates?|pos|positions?|cartesian)"
_AFTER = r"(coords?|coordinates?|pos|positions?)"
_EAST, _NORTH = r"e|east|easting|rechtswert", r"n|north|northing|hochwert"
_ELEVATION, _HEIGHT = r"elev|elevation", r"height|alt|altitude"
# What coordinates are called, letters and digits alone; the first that are there count.
COORDINATES = (
    ("x", "y", "z"),
    tuple(rf"{_BEFORE}?{axis}{_AFTER}?" for axis in "xyz"),
    tuple(rf"{_BEFORE}{number}" for number in range(3)),  # ParaView's
    *((_EAST, _NORTH, height) for height in ("z", _ELEVATION, rf"{_HEIGHT}|h|u|up|hoehe|höhe")),
    *(("x", "y", height) for height in (_ELEVATION, _HEIGHT)),
)
COLOURS = (
    ("red", "green", "blue"),
    ("r", "g", "b"),
    tuple(rf"(rgba?|colou?rs?){number}" for number in range(3)),
)


@dataclass
class Columns:
    """Where things stand in a line."""

    coordinates: tuple[int, ...]
    colours: tuple[int, ...] | None
    """None: there are none."""

    @property
    def used(self) -> tuple[int, ...]:
        """All columns that are read."""
        return self.coordinates + (self.colours or ())


@dataclass
class Header:
    """Lines before the points that name coordinates."""

    line: str | None = None
    """That is no comment."""
    comments: list[str] = field(default_factory=list)

    def add_comment(self, line: str) -> None:
        """Keep a comment if it may be a header."""
        if _names_coordinates(line):
            self.comments.append(line)

    def add_line(self, path: Path, line: str) -> None:
        """Keep a line that is no comment; raises UnreadableFile if it is no header."""
        if not _names_coordinates(line):
            if max(map(len, _partings(line))) < 3:
                raise UnreadableFile(path, f"its first line is none of points: '{line[:60]}'.")
            raise UnreadableFile(
                path, f"its header names no coordinates, such as x, y and z: '{line[:60]}'."
            )
        self.line = line

    def columns(self, path: Path, counts: tuple[int, int], separator: str | None) -> Columns | None:
        """Return which columns are what, None where no header says it.

        `counts` are the numbers of fields of the first line of points, without empty ones at its
        end and with them. Raises UnreadableFile where the header has
        another number of columns, or names a coordinate twice.
        """
        if self.line is not None:
            if found := _fitting(path, self.line, counts, separator):
                return found
            raise _mismatch(path, self.line, counts, separator)
        for line in reversed(self.comments):
            if found := _fitting(path, line, counts, separator):
                return found
        # Prose that speaks of x, y and z is no header; of more columns, they might be any three.
        for line in self.comments:
            if counts[0] > 3 and all(_places(t) != (0, 1, 2) for t in _partings(line)):
                raise _mismatch(path, line, counts, separator)
        return None


def _fitting(
    path: Path, line: str, counts: tuple[int, int], separator: str | None
) -> Columns | None:
    """The columns by the first parting that has as many, that of the points before others."""
    for titles in _partings(line, separator):
        if not _fits(titles, counts) or not (places := _places(titles)):
            continue
        if len(set(places)) < 3 or -1 in places:
            raise UnreadableFile(path, f"its header names a coordinate twice: '{line[:60]}'.")
        colours = next(filter(None, (_found(titles, names) for names in COLOURS)), None)
        return Columns(places, None if colours and -1 in colours else colours)
    return None


def _mismatch(
    path: Path, line: str, counts: tuple[int, int], separator: str | None
) -> UnreadableFile:
    titles = next(_partings(line, separator))
    return UnreadableFile(
        path,
        f"its header has {len(titles)} titles, but its first line of points {counts[0]} numbers, "
        f"so that it is unknown which are coordinates: '{line[:60]}'.",
    )


def _fits(titles: list[str], counts: tuple[int, int]) -> bool:
    filled = len(titles)
    while filled and not titles[filled - 1]:
        filled -= 1
    return filled == counts[0] or len(titles) == counts[1]


def _names_coordinates(line: str) -> bool:
    return any(map(_places, _partings(line)))


def _partings(line: str, first: str | None = None) -> Iterator[list[str]]:
    """The titles by each separator, by `first` before others."""
    for separator in sorted(SEPARATORS, key=lambda each: each != first):
        yield [_plain(title) for title in _titles(line[:LONGEST], separator)]


def _titles(line: str, separator: str | None) -> list[str]:
    if separator is None:
        return re.findall(r'"[^"]*"|\S+', UNIT_IN_BRACKETS.sub(" ", line))
    cleaned = line.strip("\r\n").replace("\0", "")
    return next(csv.reader([cleaned], delimiter=separator, skipinitialspace=True), [])


def _plain(title: str) -> str:
    """A title in small letters and digits, without its unit."""
    bare = UNIT_IN_BRACKETS.sub(" ", title.lower()).strip(" \"'")
    return re.sub(r"[\W_]", "", UNIT_AT_END.sub("", bare))


def _places(titles: list[str]) -> tuple[int, ...] | None:
    return next(filter(None, (_found(titles, names) for names in COORDINATES)), None)


def _found(titles: list[str], names: tuple[str, ...]) -> tuple[int, ...] | None:
    """The columns with these names, -1 where several have one; None where one is missing."""
    places = []
    for name in names:
        found = [place for place, title in enumerate(titles) if re.fullmatch(name, title)]
        if not found:
            return None
        places.append(found[0] if len(found) == 1 else -1)
    return tuple(places)
