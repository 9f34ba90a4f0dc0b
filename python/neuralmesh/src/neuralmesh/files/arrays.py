# SPDX-License-Identifier: GPL-3.0-or-later
"""NPY and NPZ. An NPY file is mapped, not loaded."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from .cloud import Chunk
from .registry import UnreadableFile

POINTS = 1_000_000
NAMES = ("points", "vertices", "xyz", "positions", "pos")
COLOURS = ("colours", "colors", "rgb")


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the rows of the array; in an NPZ of that called points, or of the only one."""
    colours = None
    if path.suffix.lower() == ".npy":
        points = np.load(path, mmap_mode="r", allow_pickle=False)
    else:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
            points = archive[_name_of_points(path, archive.files)]
            named = next((name for name in COLOURS if name in archive.files), None)
            colours = None if named is None else archive[named]
    if points.ndim != 2 or points.shape[1] < 3 or points.dtype.kind not in "fiu":
        raise UnreadableFile(
            path, f"it holds {points.dtype} of the shape {points.shape}, not N x 3."
        )
    if colours is not None and (len(colours) != len(points) or colours.dtype != np.uint8):
        colours = None
    for begin in range(0, len(points), POINTS):
        part = slice(begin, begin + POINTS)
        yield Chunk(
            np.array(points[part, :3], dtype=np.float64),
            None if colours is None else np.array(colours[part, :3]),
            min(1.0, (begin + POINTS) / len(points)),
        )


def _name_of_points(path: Path, names: list[str]) -> str:
    for name in NAMES:
        if name in names:
            return name
    if len(names) == 1:
        return names[0]
    raise UnreadableFile(path, f"none of its arrays ({', '.join(names)}) is called points.")
