# SPDX-License-Identifier: GPL-3.0-or-later
"""The header of a PLY file, as far as it says where the vertices are."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, BinaryIO

import numpy as np

LONGEST = 65_536  # bytes, as in the core
FORMATS = {b"ascii": "", b"binary_little_endian": "<", b"binary_big_endian": ">"}
TYPES = {
    **{b"char": "i1", b"int8": "i1", b"uchar": "u1", b"uint8": "u1"},
    **{b"short": "i2", b"int16": "i2", b"ushort": "u2", b"uint16": "u2"},
    **{b"int": "i4", b"int32": "i4", b"uint": "u4", b"uint32": "u4"},
    **{b"float": "f4", b"float32": "f4", b"double": "f8", b"float64": "f8"},
}


@dataclass
class Element:
    """Records of one kind."""

    name: bytes
    count: int
    fields: list[tuple[str, str]] = field(default_factory=list)
    """Names and types, without lists."""
    has_list: bool = False


@dataclass
class Header:
    """Up to the vertices; what follows them is not looked at."""

    order: str
    """Of bytes, "<" or ">"; empty where the file is text."""
    elements: list[Element]
    """The last is that of the vertices."""
    lines: bytes
    """A header that ends with the vertices."""

    @property
    def is_text(self) -> bool:
        """Whether each vertex is a line."""
        return not self.order

    @property
    def vertices(self) -> Element:
        """The element of vertices."""
        return self.elements[-1]

    @property
    def record(self) -> np.dtype[Any] | None:
        """Of a vertex; None where vertices are not found without reading all before them."""
        if not self.order or any(each.has_list for each in self.elements):
            return None
        return self._record(self.vertices)

    @property
    def bytes_before(self) -> int:
        """Between the header and the vertices, where `record` is not None."""
        return sum(each.count * self._record(each).itemsize for each in self.elements[:-1])

    def _record(self, element: Element) -> np.dtype[Any]:
        return np.dtype([(name, self.order + kind) for name, kind in element.fields])


def read_header(file: BinaryIO) -> Header | None:
    """Return the header, and leave the file behind it; None where it is no header of vertices."""
    order, elements, lines = None, [], []
    if file.readline(8).strip() != b"ply":
        return None
    left = LONGEST
    while line := file.readline(left):
        left -= len(line)
        words = line.split()
        if words == [b"end_header"]:
            break
        is_behind = bool(elements) and elements[-1].name == b"vertex"
        if words[:1] == [b"format"] and len(words) == 3:
            order = FORMATS.get(words[1])
        elif words[:1] == [b"element"] and len(words) == 3 and words[2].isdigit():
            if is_behind:
                _skip(file, left)
                break
            elements.append(Element(words[1], int(words[2])))
        elif words[:1] == [b"property"] and not (elements and _add(elements[-1], words)):
            return None
        lines.append(line)
    else:
        return None
    if order is None or not elements or elements[-1].name != b"vertex":
        return None
    names = [name for each in elements for name, _ in each.fields if each.name == b"vertex"]
    if len(set(names)) < len(names):
        return None
    return Header(order, elements, b"ply\n" + b"".join(lines) + b"end_header\n")


def _add(element: Element, words: list[bytes]) -> bool:
    """Add a property; return whether it is one."""
    if words[1:2] == [b"list"]:
        element.has_list = True
        return True
    if len(words) != 3 or words[1] not in TYPES:
        return False
    element.fields.append((words[2].decode("latin-1"), TYPES[words[1]]))
    return True


def _skip(file: BinaryIO, left: int) -> None:
    while line := file.readline(left):
        left -= len(line)
        if line.split() == [b"end_header"]:
            return
