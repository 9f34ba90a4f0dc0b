# SPDX-License-Identifier: GPL-3.0-or-later
"""Point clouds out of nothing, for tests and benchmarks, and PLY files of them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from neuralmesh_tools.geometry import Points


def bumpy_ellipsoid(count: int, seed: int) -> Points:
    """Return points (count, 3) on an ellipsoid with waves, other ones for each seed."""
    generator = np.random.default_rng(seed)
    directions = generator.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    waves = 1 + 0.1 * np.sin(directions @ generator.normal(scale=3, size=(3, 3))).sum(axis=1)
    stretched: Points = directions * waves[:, None] * generator.uniform(0.5, 1, size=3)
    return stretched


def sphere(count: int, seed: int) -> NDArray[np.float32]:
    """Return points (count, 3) on the unit sphere, uniformly, in single precision."""
    points = np.random.default_rng(seed).standard_normal((count, 3), dtype=np.float32)
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def write_clouds(folder: Path, count: int, points: int = 2000) -> list[Path]:
    """Write cloud000.ply, cloud001.ply, ..., each another shape of so many points.

    Returns their paths.
    """
    folder.mkdir(parents=True, exist_ok=True)
    paths = [folder / f"cloud{number:03}.ply" for number in range(count)]
    for seed, path in enumerate(paths):
        write_ply(path, bumpy_ellipsoid(points, seed))
    return paths


def write_ply(path: Path, points: ArrayLike) -> None:
    """Write points (n, 3) as a binary PLY file in single precision."""
    array = np.asarray(points)
    write_ply_in_chunks(path, len(array), [array])


def write_ply_in_chunks(path: Path, count: int, chunks: Iterable[ArrayLike]) -> None:
    """Write `count` points, which come in chunks (n, 3), as binary PLY in single precision."""
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\n"
    header += "".join(f"property float {axis}\n" for axis in "xyz") + "end_header\n"
    with path.open("wb") as stream:
        stream.write(header.encode("ascii"))
        for chunk in chunks:
            stream.write(np.ascontiguousarray(chunk, dtype="<f4").tobytes())
