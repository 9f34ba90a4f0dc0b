# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the constants out of the C++ source: names, values, and what the comments say of them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

FOLDER = "filter_neuralmesh"
SEARCHED = ("core", "samplers")
PARAMETERS = "include/neuralmesh/parameters.h"
# The one constant of the public headers.
ATTRIBUTES = "include/neuralmesh/attribute_transfer.h"

_NUMBERS = (
    "double|float|int|unsigned|Scalar|std::size_t|std::uint32_t|std::uint64_t"
    "|FaceId|VertexId|CellId|Place"
)
# A table of more than one dimension lists cases of a mesh or a cell: it is no constant to choose.
_CONSTANT = re.compile(
    rf"^(?P<indent> *)(?:(?:inline|static) )*constexpr (?:{_NUMBERS}) "
    r"(?P<name>\w+)(?:\[\])? = (?P<value>[^;]+);(?P<behind>.*)$",
    re.MULTILINE,
)
_DEFAULT = re.compile(r"^ {4}(?:int|double) (?P<name>\w+) = (?P<value>[\d.]+);$", re.MULTILINE)


@dataclass(frozen=True)
class Constant:
    """A number that the source gives a name, at namespace or class scope."""

    file: str
    """Below filter_neuralmesh."""
    name: str
    value: str
    """As it is written, in one line."""
    text: str
    """From its name to its semicolon: stands once in the file."""
    comment: str
    """What the source says of it; empty where it says nothing."""
    see: str
    """The constant further up in the same lines whose comment is of this one too, if any."""

    @property
    def key(self) -> tuple[str, str]:
        """The file and the name, which no other constant has."""
        return self.file, self.name

    @property
    def path(self) -> str:
        """The file, from the root of the project."""
        return f"{FOLDER}/{self.file}"

    def text_with(self, value: str) -> str:
        """The text with another value."""
        return f"{self.name}{self.text[len(self.name) :].split('=')[0]}= {value};"


def read_constants(root: Path) -> dict[tuple[str, str], Constant]:
    """Return all constants by file and name, file by file, in their order."""
    found = {}
    for file in _files(root):
        text = (root / FOLDER / file).read_text(encoding="utf-8")
        for constant in constants_in(file, text):
            found[constant.key] = constant
    return found


def constants_in(file: str, text: str) -> Iterator[Constant]:
    """Yield the constants of one file, given its text."""
    pattern = _DEFAULT if file == PARAMETERS else _CONSTANT
    last_line = -1
    head = ""
    for match in pattern.finditer(text):
        before = text[: match.start()].splitlines()
        if match.groupdict().get("indent") and not _is_in_class(before, len(match["indent"])):
            continue
        behind = _comment_behind(match.groupdict().get("behind") or "")
        above = _comment_above(before)
        if above or last_line != len(before):
            head = match["name"]
        last_line = len(before) + match[0].count("\n") + 1
        see = "" if behind or head == match["name"] else head
        start, end = match.start("name"), match.end("value") + 1
        value = " ".join(match["value"].split())
        yield Constant(file, match["name"], value, text[start:end], behind or above, see)


def _files(root: Path) -> list[str]:
    folder = root / FOLDER
    found = [
        path.relative_to(folder).as_posix()
        for part in SEARCHED
        for path in (folder / part).rglob("*")
        if path.suffix in (".h", ".cpp")
    ]
    return [PARAMETERS, ATTRIBUTES, *sorted(found)]


def _is_in_class(before: list[str], indent: int) -> bool:
    """Whether the innermost block that is open begins with a class's head, not a function's."""
    for line in reversed(before):
        own = len(line) - len(line.lstrip())
        if not line.strip() or own >= indent or line.strip().endswith(":"):
            continue
        return re.match(r"\s*(?:template .*)?(?:class|struct) ", line) is not None
    return False


def _comment_behind(text: str) -> str:
    match = re.match(r"\s*///?<? ?(.*)", text)
    return match[1].strip() if match else ""


def _comment_above(before: list[str]) -> str:
    lines: list[str] = []
    for line in reversed(before):
        match = re.match(r"\s*///?<? ?(.*)", line)
        if not match:
            break
        lines.insert(0, match[1].strip())
    return " ".join(lines)
