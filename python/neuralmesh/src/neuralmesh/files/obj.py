# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of an OBJ file in their order, with colours where they have any.

Readers of meshes part and reorder vertices by their texture coordinates; here all that counts is
where they are.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from .cloud import Chunk

LINES = 100_000


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices."""
    size, read = max(path.stat().st_size, 1), 0
    with path.open("rb") as file:
        while block := list(itertools.islice(file, LINES)):
            read += sum(map(len, block))
            vertices = [line[2:] for line in block if line.startswith((b"v ", b"v\t"))]
            if not vertices:
                continue
            has_colours = len(vertices[0].split()) >= 6
            columns = (0, 1, 2, 3, 4, 5) if has_colours else (0, 1, 2)
            numbers = np.loadtxt(vertices, usecols=columns, comments=None, ndmin=2)
            colours = None
            if has_colours:  # shares of 1
                colours = np.clip(np.rint(255 * numbers[:, 3:]), 0, 255).astype(np.uint8)
            yield Chunk(np.ascontiguousarray(numbers[:, :3]), colours, min(1.0, read / size))
