# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads files, folders of tiles and several files as one, of any format of the registry."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .cloud import Chunk, Cloud, Reservoir
from .registry import SUFFIXES, UnreadableFile, format_of

Progress = Callable[[float, str], object]

# What the core maps into memory and reads where it lies.
IN_PLACE = (".ply", ".las", ".npy")


def is_read_in_place(path: Path) -> bool:
    """Return whether the core can sample the file itself: binary PLY, LAS and NPY."""
    if path.suffix.lower() not in IN_PLACE:
        return False
    if path.suffix.lower() != ".ply":
        return True
    try:
        with path.open("rb") as file:
            return b"format ascii" not in file.read(256)
    except OSError:
        return True  # the core says what is wrong


def read(
    path: str | os.PathLike[str],
    *,
    most_points: int | None = None,
    progress: Progress | None = None,
    is_time_up: Callable[[], bool] = lambda: False,
) -> Cloud:
    """Read the points of a file, and its colours.

    PLY, OBJ, STL, OFF, glTF and GLB (their vertices), XYZ and its comma and header variants, PTS,
    PCD, LAS, LAZ, COPC, E57, NPY and NPZ; `neuralmesh.files.FORMATS` lists them. Where it holds
    more than `most_points`, a uniform choice of so many is kept, in one pass and bounded memory.
    Where `is_time_up` says so, the points so far are returned, some at the least.

    Raises `ValueError` (`files.UnreadableFile`) where the file is of an unknown format, broken or
    without points, OSError where it cannot be opened.
    """
    return read_merged(
        [Path(path)], most_points=most_points, progress=progress, is_time_up=is_time_up
    )


def read_merged(
    paths: Iterable[Path],
    *,
    most_points: int | None = None,
    progress: Progress | None = None,
    is_time_up: Callable[[], bool] = lambda: False,
) -> Cloud:
    """Read several files as one cloud; see read()."""
    listed = list(paths)
    reservoir = Reservoir(most_points)
    for number, path in enumerate(listed):
        for chunk in _chunks(path):
            reservoir.add(chunk)
            if progress is not None:
                done = (number + chunk.done) / len(listed)
                if progress(done, f"Reading {path.name}") is False:
                    from .._core import Cancelled

                    raise Cancelled("Cancelled.")
            if is_time_up():
                return reservoir.cloud()
    if reservoir.total == 0:
        raise UnreadableFile(listed[0] if listed else Path(), "it holds no points.")
    return reservoir.cloud()


def expand(path: Path) -> list[Path]:
    """Return the files of a folder that can be read, by name, hidden ones apart; or the file."""
    if not path.is_dir():
        return [path]
    # Programs hide what is no scan, such as ._x.ply beside x.ply on disks of macOS.
    files = [file for file in path.iterdir() if not file.name.startswith(".")]
    found = sorted(file for file in files if file.suffix.lower() in SUFFIXES)
    if not found:
        raise UnreadableFile(path, "the folder holds no file that can be read.")
    return found


@dataclass
class Description:
    """What a file holds."""

    format: str
    points: int
    lower: list[float]
    upper: list[float]
    has_colours: bool
    not_finite: int
    """Points with a coordinate that is NaN or infinite; the bounds leave them out."""
    in_place: bool

    @property
    def diagonal(self) -> float:
        """Of the bounding box."""
        return float(np.linalg.norm(np.subtract(self.upper, self.lower)))


def describe(path: Path, progress: Progress | None = None) -> Description:
    """Look at all points of a file, in bounded memory."""
    count, broken, has_colours = 0, 0, False
    lower, upper = np.full(3, np.inf), np.full(3, -np.inf)
    for chunk in _chunks(path):
        count += len(chunk.points)
        has_colours |= chunk.colours is not None
        finite = np.isfinite(chunk.points).all(axis=1)
        broken += int((~finite).sum())
        if finite.any():
            lower = np.minimum(lower, chunk.points[finite].min(axis=0))
            upper = np.maximum(upper, chunk.points[finite].max(axis=0))
        if progress is not None:
            progress(chunk.done, f"Reading {path.name}")
    if count == broken:
        raise UnreadableFile(path, "it holds no points.")
    return Description(
        format_of(path).name,
        count,
        lower.tolist(),
        upper.tolist(),
        has_colours,
        broken,
        is_read_in_place(path),
    )


def _chunks(path: Path) -> Iterator[Chunk]:
    """The points of a file; whatever a reader stumbles over is told with the path."""
    if path.is_dir():
        raise UnreadableFile(path, "it is a folder.")
    if not path.exists():
        raise UnreadableFile(path, "there is no such file.")
    known = format_of(path)
    try:
        yield from known.chunks(path)
    except (UnreadableFile, OSError, MemoryError):
        raise
    except Exception as error:  # libraries raise errors of their own for broken files
        raise UnreadableFile(
            path, f"it cannot be read as {known.name}: {_sentence(error)}"
        ) from error


def _sentence(error: Exception) -> str:
    text: Any = " ".join(str(error).split()) or type(error).__name__
    return text if text.endswith(".") else text + "."
