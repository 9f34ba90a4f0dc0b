# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads files, folders of tiles and several files as one, of any format of the registry."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .cloud import Chunk, Cloud, Reservoir
from .in_place import is_read_in_place
from .registry import UnreadableFile, format_of
from .signatures import require_whole

Progress = Callable[[float, str], object]


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
    more than `most_points`, a uniform choice of so many is kept, in one pass and bounded memory;
    only glTF, GLB, PCD by binary_compressed, NPZ by columns and PLY of lists are loaded whole.
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
        raise _without_points(listed[0] if listed else Path(), reservoir.left_out)
    return reservoir.cloud()


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
    count, broken, left_out, has_colours = 0, 0, 0, False
    lower, upper = np.full(3, np.inf), np.full(3, -np.inf)
    for chunk in _chunks(path):
        count += len(chunk.points)
        left_out += chunk.left_out
        has_colours |= chunk.colours is not None
        finite = np.isfinite(chunk.points).all(axis=1)
        broken += int((~finite).sum())
        if finite.any():
            lower = np.minimum(lower, chunk.points[finite].min(axis=0))
            upper = np.maximum(upper, chunk.points[finite].max(axis=0))
        if progress is not None:
            progress(chunk.done, f"Reading {path.name}")
    if count == broken:
        raise _without_points(path, count + left_out)
    return Description(
        format_of(path).name,
        count,
        lower.tolist(),
        upper.tolist(),
        has_colours,
        broken,
        is_read_in_place(path),
    )


def _without_points(path: Path, invalid: int) -> UnreadableFile:
    if invalid == 0:
        return UnreadableFile(path, "it holds no points.")
    return UnreadableFile(path, f"none of its {invalid:,} points is finite and valid.")


def _chunks(path: Path) -> Iterator[Chunk]:
    """The points of a file; whatever a reader stumbles over is told with the path."""
    if path.is_dir():
        raise UnreadableFile(path, "it is a folder.")
    if not path.exists():
        raise UnreadableFile(path, "there is no such file.")
    known, read = format_of(path), 0
    require_whole(path)
    try:
        for chunk in known.chunks(path):
            read += len(chunk.points)
            yield chunk
    except (UnreadableFile, MemoryError):
        raise
    except OSError as error:
        if error.filename is not None and Path(error.filename) == path:
            raise
        raise UnreadableFile(path, f"it cannot be read: {_of_system(error)}") from error
    except ImportError as error:  # of what libraries import only for some contents
        raise UnreadableFile(
            path, f"its content is another, or the package {error.name} is missing."
        ) from error
    except Exception as error:  # libraries raise errors of their own for broken files
        reason = f"it is broken, or its content is not {known.name}."
        if read:
            reason = f"it is broken behind its first {read:,} points."
        raise UnreadableFile(path, reason) from error


def _of_system(error: OSError) -> str:
    """Of another file, that this one needs, or of none that is known."""
    if isinstance(error, FileNotFoundError):
        return f"a file that it needs is missing: '{error.filename or error}'."
    if error.filename is None:
        return f"{error.strerror or 'the system says nothing of the reason'}."
    return f"the file '{error.filename}', which it needs: {error.strerror}."
