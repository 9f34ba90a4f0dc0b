# SPDX-License-Identifier: GPL-3.0-or-later
"""The clouds of the table of strays, the surfaces they are of, and the strays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from neuralmesh_tools import datasets, generated_clouds
from neuralmesh_tools.geometry import Faces, Points

# Of 20 strays and more, some lie together: ten, as a bird or a cable has them. A mesh of 1,000
# vertices would have two for them.
CLUMP = 10
CLUMP_RADIUS = 0.01
# A stray stored again and again: all copies of all strays together, and those of one.
MOST_COPIES = 20_000
MOST_COPIES_OF_ONE = 1_000
# In radii. What lies nearer may lie at the surface: noise, which the quality table's outliers are.
NEAREST = 1.2


@dataclass(frozen=True)
class Body:
    """Points (n, 3) and the surface they are of; parameters of the filter for such data."""

    points: Points
    surface: tuple[Points, Faces]
    vertices: int = 1_000
    parameters: dict[str, Any] = field(default_factory=dict)

    @property
    def middle(self) -> Points:
        """The middle of the points' bounding box."""
        middle: Points = (self.points.min(axis=0) + self.points.max(axis=0)) / 2
        return middle

    @property
    def radius(self) -> float:
        """The distance from the middle to the furthest point."""
        return float(np.linalg.norm(self.points - self.middle, axis=1).max())


def sphere() -> Body:
    """5,000 points of the unit sphere, and the sphere as a fine mesh."""
    points = np.asarray(generated_clouds.sphere(5_000, 0), dtype=np.float64)
    around, up = np.linspace(0, 2 * np.pi, 401), np.linspace(0, np.pi, 201)
    a, b = np.meshgrid(around, up, indexing="ij")
    fine = np.c_[
        (np.cos(a) * np.sin(b)).ravel(), (np.sin(a) * np.sin(b)).ravel(), np.cos(b).ravel()
    ]
    return Body(points, (fine, _grid_faces(401, 201)))


def bunny() -> Body:
    """The bunny's 28,088 points."""
    points, faces = datasets.load("bunny")
    return Body(points, (points, faces))


def terrain() -> Body:
    """20,000 points of a hilly square, at random."""
    x, y = np.random.default_rng(3).uniform(0, 10, (2, 20_000))
    along = np.linspace(0, 10, 301)
    u, v = (axis.ravel() for axis in np.meshgrid(along, along, indexing="ij"))
    surface = np.c_[u, v, _height(u, v)]
    faces = _grid_faces(301, 301)
    return Body(np.c_[x, y, _height(x, y)], (surface, faces), parameters={"boundaries": 1})


def face() -> Body:
    """A raw range scan of 85,849 points, with holes and a border."""
    points, faces = datasets.load("face")
    return Body(points, (points, faces), parameters={"boundaries": 1})


BODIES: dict[str, Callable[[], Body]] = {
    "sphere": sphere,
    "bunny": bunny,
    "terrain": terrain,
    "face": face,
}


def single(count: int, reach: float, generator: np.random.Generator) -> Points:
    """Strays (count, 3) anywhere from NEAREST to reach, uniform in space."""
    cubes = generator.uniform((NEAREST / reach) ** 3, 1, (count, 1))
    return _directions(count, generator) * reach * np.cbrt(cubes)


def tails(count: int, reach: float, generator: np.random.Generator) -> Points:
    """Strays (count, 3) as many at each order of distance, up to reach."""
    logarithms = generator.uniform(np.log(NEAREST), np.log(reach), (count, 1))
    return _directions(count, generator) * np.exp(logarithms)


def repeated(count: int, reach: float, generator: np.random.Generator) -> Points:
    """Strays at `count` places up to reach, each stored up to a thousand times."""
    copies = min(MOST_COPIES_OF_ONE, MOST_COPIES // count)
    return np.repeat(single(count, reach, generator), copies, axis=0)


def clumps(count: int, reach: float, generator: np.random.Generator) -> Points:
    """Strays (count, 3) of which ten each lie together, somewhere up to reach."""
    places = single(-(-count // CLUMP), reach, generator)
    around = CLUMP_RADIUS * generator.uniform(-1, 1, (count, 3))
    return np.repeat(places, CLUMP, axis=0)[:count] + around


# By name: so many strays of a cloud of radius 1 about the origin, within so many radii.
KINDS: dict[str, Callable[[int, float, np.random.Generator], Points]] = {
    "single": single,
    "tails": tails,
    "repeated": repeated,
    "clumps": clumps,
}


def strays(body: Body, kind: str, count: int, reach: float) -> Points:
    """Strays within so many radii of a body; the same arguments always give the same."""
    generator = np.random.default_rng([list(KINDS).index(kind), count, int(10 * reach)])
    return body.middle + body.radius * KINDS[kind](count, reach, generator)


def _height(x: Points, y: Points) -> Points:
    height: Points = 0.4 * np.sin(1.1 * x) * np.cos(0.9 * y) + 0.1 * np.sin(3 * x + y)
    return height


def _grid_faces(rows: int, columns: int) -> Faces:
    """Two triangles for each square of a grid of points, in rows."""
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    lower = np.c_[corner, corner + columns, corner + 1]
    upper = np.c_[corner + 1, corner + columns, corner + columns + 1]
    return np.vstack([lower, upper]).astype(np.int32)


def _directions(count: int, generator: np.random.Generator) -> Points:
    directions = generator.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return directions
