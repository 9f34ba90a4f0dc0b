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
    directions = _directions(count, generator)
    waves = 1 + 0.1 * np.sin(directions @ generator.normal(scale=3, size=(3, 3))).sum(axis=1)
    stretched: Points = directions * waves[:, None] * generator.uniform(0.5, 1, size=3)
    return stretched


def sphere(count: int, seed: int) -> NDArray[np.float32]:
    """Return points (count, 3) on the unit sphere, uniformly, in single precision."""
    points = np.random.default_rng(seed).standard_normal((count, 3), dtype=np.float32)
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def torus(count: int, seed: int) -> Points:
    """Return points (count, 3) on a torus of radii 1 and 0.4, uniformly by area."""
    generator = np.random.default_rng(seed)
    around, across = np.empty((2, 0))
    while len(around) < count:
        angles = generator.uniform(0, 2 * np.pi, (2, count))
        # A piece of the tube has an area in proportion to its distance from the axis.
        kept = generator.random(count) < (1 + 0.4 * np.cos(angles[1])) / 1.4
        around, across = np.append(around, angles[0, kept]), np.append(across, angles[1, kept])
    around, across = around[:count], across[:count]
    distance = 1 + 0.4 * np.cos(across)
    return np.c_[distance * np.cos(around), distance * np.sin(around), 0.4 * np.sin(across)]


def spheres(count: int, seed: int, centres: Points, radii: NDArray[np.float64]) -> Points:
    """Return points (count, 3) on spheres with centres (k, 3) and radii (k,), by area."""
    generator = np.random.default_rng(seed)
    chosen = generator.choice(len(radii), size=count, p=radii**2 / np.sum(radii**2))
    drawn: Points = centres[chosen] + radii[chosen, None] * _directions(count, generator)
    return drawn


def two_spheres(count: int, seed: int) -> Points:
    """Return points (count, 3) on two unit spheres, 1 apart."""
    return spheres(count, seed, np.array([[-1.5, 0, 0], [1.5, 0, 0]]), np.ones(2))


def twenty_spheres(count: int, seed: int) -> Points:
    """Return points (count, 3) on 20 spheres of radius 0.2 to 0.7, at least 0.25 apart.

    The spheres lie elsewhere, and have other sizes, for each seed.
    """
    generator = np.random.default_rng([seed, 20])
    centres, radii = np.empty((0, 3)), np.empty(0)
    while len(radii) < 20:
        centre, radius = generator.uniform(-3, 3, 3), generator.uniform(0.2, 0.7)
        if np.all(np.linalg.norm(centres - centre, axis=1) > radii + radius + 0.25):
            centres, radii = np.vstack([centres, centre]), np.append(radii, radius)
    return spheres(count, seed, centres, radii)


def cap(count: int, seed: int, half_angle: float) -> Points:
    """Return points (count, 3) of the unit sphere within an angle of its pole, in degrees."""
    generator = np.random.default_rng(seed)
    height = generator.uniform(np.cos(np.radians(half_angle)), 1, count)
    around = generator.uniform(0, 2 * np.pi, count)
    radius = np.sqrt(1 - height**2)
    return np.c_[radius * np.cos(around), radius * np.sin(around), height]


def flat_square(count: int, seed: int) -> Points:
    """Return points (count, 3) of the unit square in the plane of x and y."""
    return np.c_[np.random.default_rng(seed).random((count, 2)), np.zeros(count)]


def bent_sheet(count: int, seed: int) -> Points:
    """Return points (count, 3) of a unit square, bent to heights of up to 0.2."""
    square = flat_square(count, seed)
    square[:, 2] = 0.2 * np.sin(3 * square[:, 0]) * square[:, 1]
    return square


def terrain_grid() -> Points:
    """Return a height field of 60 x 40 points (2400, 3) over 3 x 2, a regular grid."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 3, 60), np.linspace(0, 2, 40)))
    return np.c_[x, y, 0.15 * np.sin(2.1 * x) * np.cos(1.7 * y) + 0.05 * np.sin(6 * x + 2 * y)]


def tube(count: int, seed: int) -> Points:
    """Return points (count, 3) of a tube of radius 1 and length 4, open at both ends."""
    generator = np.random.default_rng(seed)
    around, height = generator.uniform(0, 2 * np.pi, count), generator.uniform(-2, 2, count)
    return np.c_[np.cos(around), np.sin(around), height]


def cup(count: int, seed: int, wall: float) -> Points:
    """Return points (count, 3) on a cup's outside, inside, rim and bottoms, uniformly by area.

    Its outer radius is 1, its height 2; wall is how thick its side and its bottom are.
    """
    generator = np.random.default_rng(seed)
    inner = 1 - wall
    # Rings (radius and height at either end) whose areas are 2 pi * mean radius * length.
    rings = np.array(
        [
            [[1, 0], [1, 2]],
            [[inner, wall], [inner, 2]],
            [[0, 0], [1, 0]],
            [[0, wall], [inner, wall]],
            [[inner, 2], [1, 2]],
        ]
    )
    start, end = rings[:, 0], rings[:, 1]
    areas = (start[:, 0] + end[:, 0]) * np.linalg.norm(end - start, axis=1)
    chosen = generator.choice(len(rings), size=count, p=areas / areas.sum())
    start, end = start[chosen], end[chosen]
    along, around = generator.random(count), generator.uniform(0, 2 * np.pi, count)
    radius = np.sqrt((1 - along) * start[:, 0] ** 2 + along * end[:, 0] ** 2)
    height = (1 - along) * start[:, 1] + along * end[:, 1]
    return np.c_[radius * np.cos(around), radius * np.sin(around), height]


def cup_volume(wall: float) -> float:
    """The volume of the cup's material."""
    return float(np.pi * 2 - np.pi * (1 - wall) ** 2 * (2 - wall))


def _directions(count: int, generator: np.random.Generator) -> Points:
    directions = generator.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return directions


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
