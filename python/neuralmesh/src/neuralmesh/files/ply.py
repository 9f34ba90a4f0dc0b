# SPDX-License-Identifier: GPL-3.0-or-later
"""PLY, binary and text, by plyfile: vertices of a binary file are mapped, not loaded."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from plyfile import PlyData

from .cloud import Chunk
from .registry import UnreadableFile

POINTS = 1_000_000
COLOURS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"))


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices."""
    ply = PlyData.read(str(path), mmap="c")
    if "vertex" not in ply:
        raise UnreadableFile(path, "it has no vertices.")
    vertices = ply["vertex"].data
    names = vertices.dtype.names or ()
    if not {"x", "y", "z"} <= set(names):
        raise UnreadableFile(path, "its vertices have no x, y and z.")
    colour_names = next((c for c in COLOURS if set(c) <= set(names)), None)
    for begin in range(0, len(vertices), POINTS):
        part = vertices[begin : begin + POINTS]
        points = np.column_stack([part[axis].astype(np.float64) for axis in "xyz"])
        colours = None
        if colour_names is not None:
            colours = np.column_stack([_as_bytes(part[name]) for name in colour_names])
        yield Chunk(points, colours, min(1.0, (begin + POINTS) / max(len(vertices), 1)))


def _as_bytes(values: np.ndarray) -> np.ndarray:
    if values.dtype.kind == "f":
        values = np.rint(255 * values)
    elif values.dtype.itemsize == 2:
        values = values // 256
    return np.clip(values, 0, 255).astype(np.uint8)
