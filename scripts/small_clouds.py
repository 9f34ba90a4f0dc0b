# SPDX-License-Identifier: GPL-3.0-or-later
"""Many small point clouds, each another shape: work for batches, made in no time."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike


def write_clouds(folder: Path, count: int, points: int = 2000) -> list[Path]:
    """Write cloud000.ply, cloud001.ply, ... of so many points each and return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = [folder / f"cloud{number:03}.ply" for number in range(count)]
    for seed, path in enumerate(paths):
        write_ply(path, bumpy_ellipsoid(points, seed))
    return paths


def bumpy_ellipsoid(count: int, seed: int) -> np.ndarray:
    """Return points (count, 3) on an ellipsoid with waves, other ones for each seed."""
    generator = np.random.default_rng(seed)
    directions = generator.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    waves = 1 + 0.1 * np.sin(directions @ generator.normal(scale=3, size=(3, 3))).sum(axis=1)
    stretched: np.ndarray = directions * waves[:, None] * generator.uniform(0.5, 1, size=3)
    return stretched


def write_ply(path: Path, points: ArrayLike) -> None:
    """Write points (n, 3) as a binary PLY file in single precision."""
    array = np.ascontiguousarray(points, dtype="<f4")
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(array)}\n"
        "property float x\nproperty float y\nproperty float z\nend_header\n"
    )
    path.write_bytes(header.encode("ascii") + array.tobytes())
