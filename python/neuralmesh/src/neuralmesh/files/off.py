# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of OFF, in blocks; its faces, which follow, are never read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import numpy as np

from .cloud import Chunk
from .lines import rows
from .registry import UnreadableFile

# Texture coordinates, colours and normals stand behind x, y and z.
KEYWORD = re.compile(rb"(ST)?C?N?OFF\b", re.IGNORECASE)
LONGEST_LINE = 4096


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices; raises UnreadableFile where there are fewer than the header says."""
    with path.open("rb") as file:
        count, read = _vertex_count(path, file), 0
        for points in rows(path, file, count, (0, 1, 2), "vertices"):
            read += len(points)
            yield Chunk(np.ascontiguousarray(points), None, read / count)


def _vertex_count(path: Path, file: BinaryIO) -> int:
    """The first of three counts, which stand behind the keyword or in the next line."""
    line = _line(file)
    keyword = KEYWORD.match(line)
    if keyword is None:
        raise UnreadableFile(path, "it is no OFF file: its first line does not begin with OFF.")
    counts = line[keyword.end() :].split() or _line(file).split()
    if counts[:1] == [b"BINARY"]:
        raise UnreadableFile(path, "it is binary OFF, which is not read here.")
    if len(counts) < 2 or not all(map(bytes.isdigit, counts)):
        raise UnreadableFile(
            path, "it is cut short or broken: no counts of vertices and faces follow OFF."
        )
    return int(counts[0])


def _line(file: BinaryIO) -> bytes:
    """The next line that is neither empty nor a comment; empty at the end."""
    while line := file.readline(LONGEST_LINE):
        if content := line.split(b"#")[0].strip():
            return content
    return b""
