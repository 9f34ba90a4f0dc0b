# SPDX-License-Identifier: GPL-3.0-or-later
"""Random clouds and random legal parameters, by recipes that are small and can be printed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from neuralmesh_tools.geometry import Points

# Takes one of several options: of a Hypothesis strategy, or of a generator of random numbers.
Pick = Callable[[Sequence[Any]], Any]

# Mostly small: what is hard comes with few points, and each case is to take a tenth of a second.
COUNTS = (
    *(4, 5, 6, 7, 8, 9, 10, 12, 14, 17, 20, 25, 30, 40, 50, 60, 80, 100, 150, 200, 300) * 8,
    *(499, 500, 501, 700, 1000, 1500) * 2,
    *(5000, 20000, 100_000),
)
TARGETS = (*(4, 5, 6, 7, 8, 9, 10, 12, 13, 20, 30, 50, 64, 80, 100) * 3, 150, 250, 400)
SHARES = (0.1, 0.2, 0.5, 0.5, 0.9, 0.9, 1.0, 1.0, 1.1)  # of the points, below which targets are


@dataclass(frozen=True)
class Recipe:
    """How a cloud is made. The same recipe gives the same cloud."""

    shape: str
    count: int
    seed: int
    exponent: int = 0
    """The cloud is about 10 to the power of this large."""
    offset: float = 0
    """How far it lies from the origin, in its own size."""
    strays: int = 0
    reach: float = 1
    """How far strays lie off, in the cloud's own size."""
    broken: int = 0
    """How many coordinates are NaN or infinite."""
    is_single: bool = False
    """Whether coordinates are in single precision."""

    def points(self) -> Points:
        """Make the cloud (n, 3)."""
        generator = np.random.default_rng(self.seed)
        points = SHAPES[self.shape](self.count, generator)
        if self.strays:
            directions = generator.normal(size=(self.strays, 3))
            points = np.vstack([points, self.reach * directions])
        points = (points + self.offset) * 10.0**self.exponent
        for index in generator.integers(0, points.size, self.broken):
            points.flat[index] = generator.choice([np.nan, np.inf, -np.inf])
        return points.astype(np.float32) if self.is_single else points


@dataclass(frozen=True)
class Case:
    """A run: a cloud, and parameters by the names of PyMeshLab."""

    recipe: Recipe
    parameters: Mapping[str, Any]


def _sphere(count: int, generator: np.random.Generator) -> Points:
    points = generator.normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]


def _uniform(count: int, generator: np.random.Generator) -> Points:
    return generator.uniform(-1, 1, (count, 3))


def _clustered(count: int, generator: np.random.Generator) -> Points:
    centres = generator.uniform(-1, 1, (5, 3))
    return centres[generator.integers(0, 5, count)] + generator.normal(scale=0.02, size=(count, 3))


def _line(count: int, generator: np.random.Generator) -> Points:
    return np.outer(generator.uniform(-1, 1, count), generator.normal(size=3))


def _line_and_one(count: int, generator: np.random.Generator) -> Points:
    return np.vstack([_line(count - 1, generator), generator.uniform(-1, 1, 3)])


def _plane(count: int, generator: np.random.Generator) -> Points:
    return generator.uniform(-1, 1, (count, 2)) @ generator.normal(size=(2, 3))


def _plane_and_one(count: int, generator: np.random.Generator) -> Points:
    return np.vstack([_plane(count - 1, generator), generator.uniform(-1, 1, 3)])


def _duplicates(count: int, generator: np.random.Generator) -> Points:
    places = _sphere(max(1, count // 5), generator)
    return places[generator.integers(0, len(places), count)]


def _lattice(count: int, generator: np.random.Generator) -> Points:
    side = int(np.ceil(count ** (1 / 3)))
    places = np.stack(np.meshgrid(*[np.arange(side)] * 3), -1).reshape(-1, 3)
    return generator.permutation(places)[:count] / side


def _flat_lattice(count: int, generator: np.random.Generator) -> Points:
    side = int(np.ceil(count**0.5))
    places = np.stack(np.meshgrid(*[np.arange(side)] * 2, [0]), -1).reshape(-1, 3)
    return generator.permutation(places)[:count] / side


def _shells(count: int, generator: np.random.Generator) -> Points:
    return _sphere(count, generator) * generator.choice([0.5, 1], count)[:, None]


def _parts(count: int, generator: np.random.Generator) -> Points:
    return _sphere(count, generator) + 3 * generator.integers(0, 3, count)[:, None]


def _cap(count: int, generator: np.random.Generator) -> Points:
    points = _sphere(count, generator)
    return np.abs(points) * [1, 1, 0.5]


def _heavy_tails(count: int, generator: np.random.Generator) -> Points:
    return generator.standard_cauchy((count, 3))


SHAPES = {
    "sphere": _sphere,
    "uniform": _uniform,
    "clustered": _clustered,
    "line": _line,
    "line and one": _line_and_one,
    "plane": _plane,
    "plane and one": _plane_and_one,
    "duplicates": _duplicates,
    "lattice": _lattice,
    "flat lattice": _flat_lattice,
    "shells": _shells,
    "parts": _parts,
    "cap": _cap,
    "heavy tails": _heavy_tails,
}


def pick_recipe(pick: Pick) -> Recipe:
    """Make up a recipe of options that are picked; the first of each is the plainest."""
    strays = pick((0, 0, 0, 0, 1, 2, 20))
    return Recipe(
        shape=pick(tuple(SHAPES)),
        count=pick(COUNTS),
        seed=pick(range(1000)),
        exponent=pick((0, 0, 0, *range(-30, 31))),
        offset=pick((0, 0, 0, 1, -1000, 1e6)),
        strays=strays,
        reach=pick((1.5, 10, 1e3, 1e7)) if strays else 1,
        broken=pick((0,) * 24 + (1, 3)),
        is_single=pick((False, False, True)),
    )


def pick_parameters(pick: Pick, count: int) -> dict[str, Any]:
    """Make up parameters, each within its range, for so many points. Half of them are defaults."""
    options: dict[str, Sequence[Any]] = {
        "boundaries": (0, 1),
        "startmesh": (0, 1, 2, 4),
        "splitrule": (0, 1),
        "surfacefit": (True, False),
        "edgeflips": (True, False),
        "winnerrate": (0.06, 0.01, 0.3, 0.99),
        "smoothingrate": (0.05, 0.01, 0.3, 0.99),
        "counterdecay": (0.995, 0.5, 0.01, 0.9999),
        "smoothingpasses": (5, 1, 10),
        "signalspersplit": (100, 1, 25, 200),
        "inactivityfactor": (12, 1, 4, 50),
        "threads": (1, 2),
    }
    chosen = {name: pick(values) for name, values in options.items() if pick((False, True))}
    # To read the shape of points that fill a volume takes seconds: a third of the cases do.
    chosen["topology"] = pick((0, 0, 1))
    chosen["targetvertnum"] = _pick_up_to(pick, pick(SHARES) * count)
    chosen["randomseed"] = pick(range(1, 100))
    if pick((False, False, False, True)):
        chosen["snapshots"] = str(_pick_up_to(pick, 1.1 * chosen["targetvertnum"]))
    return chosen


def _pick_up_to(pick: Pick, most: float) -> Any:
    return pick([target for target in TARGETS if target <= most] or TARGETS[:1])


def pick_case(pick: Pick) -> Case:
    """Make up a run."""
    recipe = pick_recipe(pick)
    return Case(recipe, pick_parameters(pick, recipe.count))
