# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of STL, binary and text, in blocks; of equal corners of triangles, the first."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .cloud import Chunk
from .lines import numbers, rows_with_key
from .registry import UnreadableFile

HEADER = 84  # bytes: 80 of any kind, and the number of triangles
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
TRIANGLES = 100_000  # a tenth of a second, after which Ctrl-C is heard
MOST_REMEMBERED = 8_000_000  # vertices, in 64 MB; further ones are merged within a block only
TAIL = 4096  # bytes, in which the last line is looked for


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices; raises UnreadableFile if the file is cut short."""
    merger = Merger()
    for corners, done in _text(path) if _is_text(path) else _binary(path):
        yield Chunk(merger.new_among(corners).astype(np.float64), None, done)


class Merger:
    """Keeps of equal points the first, by a hash of 64 bits of their coordinates.

    That any two of 8,000,000 different points have the same hash has a chance of 2e-6.
    """

    def __init__(self) -> None:
        self._known = np.empty(0, np.uint64)  # sorted

    def new_among(self, points: NDArray[np.floating]) -> NDArray[np.floating]:
        """Return the points that have not been there before, in their order."""
        hashes, first = np.unique(_hashes(points), return_index=True)
        places = np.searchsorted(self._known, hashes)
        is_known = np.zeros(len(hashes), bool)
        inside = places < len(self._known)
        is_known[inside] = self._known[places[inside]] == hashes[inside]
        if len(self._known) < MOST_REMEMBERED:
            self._known = np.insert(self._known, places[~is_known], hashes[~is_known])
        return points[np.sort(first[~is_known])]


def _hashes(points: NDArray[np.floating]) -> NDArray[np.uint64]:
    # 0.0 and -0.0 are one place. Constants: SplitMix64's, by G. Steele, D. Lea and C. Flood.
    bits = (points + 0.0).astype(np.float64).view(np.uint64)
    mixed = np.zeros(len(points), np.uint64)
    for axis in range(3):
        mixed = (mixed ^ bits[:, axis]) + np.uint64(0x9E3779B97F4A7C15)
        mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        mixed ^= mixed >> np.uint64(31)
    return mixed


def _is_text(path: Path) -> bool:
    with path.open("rb") as file:
        head = file.read(TAIL)
    return head.lstrip()[:5].lower() == b"solid" and b"\0" not in head


def _binary(path: Path) -> Iterator[tuple[NDArray[np.floating], float]]:
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(HEADER)
        if len(head) < HEADER:
            raise UnreadableFile(path, "it is cut short, or no STL file.")
        promised = int.from_bytes(head[-4:], "little")
        held = (size - HEADER) // TRIANGLE.itemsize
        if held != promised:
            raise UnreadableFile(
                path,
                f"it is {'cut short' if held < promised else 'broken'}: its header promises "
                f"{promised:,} triangles, but it holds {held:,}.",
            )
        for begin in range(0, promised, TRIANGLES):
            block = np.fromfile(file, TRIANGLE, min(TRIANGLES, promised - begin))
            yield block["corners"].reshape(-1, 3), (begin + len(block)) / promised


def _text(path: Path) -> Iterator[tuple[NDArray[np.floating], float]]:
    with path.open("rb") as file:
        file.seek(max(0, path.stat().st_size - TAIL))
        lines = file.read().rstrip().splitlines()
    if not lines or not lines[-1].strip().lower().startswith(b"endsolid"):
        raise UnreadableFile(path, "it is cut short: its last line does not begin with endsolid.")
    count = 0
    for corners, done in rows_with_key(path, b"vertex"):
        count += len(corners)
        yield numbers(path, corners, (1, 2, 3)), done
    if count % 3:
        raise UnreadableFile(path, f"it is broken: its last triangle has {count % 3} corners.")
