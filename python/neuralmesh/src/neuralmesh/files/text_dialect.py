# SPDX-License-Identifier: GPL-3.0-or-later
"""How a text file writes numbers: its encoding, what parts columns, and what decimals.

Where one line can be read in two ways, it is refused: 1,5,2,5,3,5 may be three numbers or six.
"""

from __future__ import annotations

import codecs
import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

from .lines import NUMBER, SHOWN
from .registry import UnreadableFile

HEAD = 4096  # bytes by which text is told from other files
MARKS = {  # that of UTF-32 begins with that of UTF-16
    codecs.BOM_UTF32_LE: "utf-32",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}
SEPARATORS = (";", "\t", ",", None)  # None: white space
LINES_LOOKED_AT = 1000

QUOTED = re.compile(r'"([^"\n]*)"')
QUOTED_COMMA = re.compile(r'"\s*[-+]?\d+,\d[\d,.]*\s*"')
WHOLE = re.compile(r"[-+]?\d+([eE][-+]?\d+)?")
FORTRAN = re.compile(r"(?<=[\d.])[dD](?=[-+]?\d)")
# Whole fields, which are neither times such as 12:30:01.5 nor dates.
WITH_POINT, WITH_COMMA = (
    re.compile(rf"(?:^|[\s;])[-+]?\d*{mark}\d+(?=$|[\s;eEdD])") for mark in (r"\.", ",")
)


@contextmanager
def opened(path: Path) -> Iterator[TextIO]:
    """Open UTF-8, UTF-16 or UTF-32 with a mark, or Latin-1; raises UnreadableFile for others."""
    with path.open("rb") as file:
        head = file.read(HEAD)
    marked = next((name for mark, name in MARKS.items() if head.startswith(mark)), None)
    if marked is None and b"\0" in head:
        raise UnreadableFile(path, "it is not text, or UTF-16 without its mark.")
    errors = "strict" if marked else "neuralmesh-latin-1"
    with path.open(encoding=marked or "utf-8-sig", errors=errors) as text:
        try:
            yield text
        except UnicodeDecodeError:
            raise UnreadableFile(path, "it is cut short, or not text as its mark says.") from None


def _as_latin_1(error: UnicodeError) -> tuple[str, int]:
    """Take bytes that are no UTF-8 for Latin-1."""
    assert isinstance(error, UnicodeDecodeError)
    return error.object[error.start : error.end].decode("latin-1"), error.end


codecs.register_error("neuralmesh-latin-1", _as_latin_1)


@dataclass
class Dialect:
    """What parts the columns of a file, and which decimal marks it has had so far."""

    separator: str | None
    has_points: bool = False
    has_commas: bool = False

    def fields(self, line: str) -> list[str]:
        """Return the fields of a line that is plain."""
        return [field.strip() for field in line.strip().rstrip(",;").split(self.separator)]

    def plain(self, path: Path, block: list[str]) -> list[str]:
        """Return lines with decimal points, exponents by e and no quotes; raises UnreadableFile."""
        text = "".join(block)
        if '"' in text:
            if self.separator == "," and (found := QUOTED_COMMA.search(text)):
                raise UnreadableFile(
                    path,
                    f"it is unknown whether commas part decimals or thousands: {found[0]}. "
                    "Part columns by semicolons.",
                )
            text = _without_quotes(text, self.separator)
        if self.separator != ",":
            text = self._with_decimal_points(path, text)
        if "d" in text or "D" in text:
            text = FORTRAN.sub("e", text)
        return list(io.StringIO(text))

    def _with_decimal_points(self, path: Path, text: str) -> str:
        point = WITH_POINT.search(text) if "." in text else None
        comma = WITH_COMMA.search(text) if "," in text else None
        self.has_points |= point is not None
        self.has_commas |= comma is not None
        if self.has_points and self.has_commas:
            shown = next(found[0].strip(" \t\r\n;") for found in (comma, point) if found)
            raise UnreadableFile(
                path,
                "some of its numbers have points and others commas, so that it is unknown which "
                f"part decimals: '{shown}'.",
            )
        return text.replace(",", ".") if self.has_commas else text


def dialect_of(line: str) -> Dialect:
    """Return the dialect by which a line of points has the most numbers."""
    return Dialect(max(SEPARATORS, key=lambda separator: _count_numbers(line, separator)))


def require_unambiguous(path: Path, dialect: Dialect, block: list[str]) -> None:
    """Refuse lines, without a header, whose commas might part columns or decimals as well."""
    if dialect.separator != ",":
        return
    lines = [dialect.fields(line) for line in block[:LINES_LOOKED_AT] if "," in line]
    if not all(WHOLE.fullmatch(word) for words in lines for word in words):
        return
    is_varying = len({len(words) for words in lines}) > 1
    if is_varying or _may_be_fractions(list(zip(*lines, strict=True))):
        raise UnreadableFile(
            path,
            f"it is unknown whether commas part columns or decimals: '{block[0].strip()[:SHOWN]}'. "
            "Part columns by semicolons, or begin with a line of their names, such as x,y,z,r,g,b.",
        )


def _may_be_fractions(columns: list[tuple[str, ...]]) -> bool:
    """Whether some columns can be the decimals of those before them, at least three of these."""
    fractions, last = 0, 0
    for place, words in enumerate(columns):
        if place > last and all(word[0].isdigit() for word in words):  # decimals have no sign
            fractions, last = fractions + 1, place + 1
    return 0 < min(len(columns) - 3, len(columns) // 2) <= fractions


def _count_numbers(line: str, separator: str | None) -> int:
    plain = FORTRAN.sub("e", _without_quotes(line, separator))
    if separator != ",":
        plain = plain.replace(",", ".")
    words = plain.strip().rstrip(",;").split(separator)
    return sum(NUMBER.fullmatch(word.strip()) is not None for word in words)


def _without_quotes(text: str, separator: str | None) -> str:
    """Text whose quoted fields have neither quotes nor what parts columns."""
    inside = str.maketrans(" \t;", "___", "," if separator == "," else "")
    return QUOTED.sub(lambda found: found[1].strip().translate(inside), text)
