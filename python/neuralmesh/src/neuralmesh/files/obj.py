# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of an OBJ file in their order, with colours where they have any.

Readers of meshes part and reorder vertices by their texture coordinates; here all that counts is
where they are.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from .cloud import Chunk
from .lines import numbers, rows_with_key


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices."""
    for vertices, done in rows_with_key(path, b"v"):
        if not vertices:
            continue
        has_colours = len(vertices[0].split()) >= 7
        columns = (1, 2, 3, 4, 5, 6) if has_colours else (1, 2, 3)
        values = numbers(path, vertices, columns)
        colours = None
        if has_colours:  # shares of 1
            colours = np.clip(np.rint(255 * values[:, 3:]), 0, 255).astype(np.uint8)
        yield Chunk(np.ascontiguousarray(values[:, :3]), colours, done)
