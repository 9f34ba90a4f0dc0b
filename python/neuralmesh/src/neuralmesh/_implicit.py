# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples of the surface on which a Python function is zero.

The method is that of the core's ImplicitSampler, on whole arrays: by Crofton's formula a surface
meets isotropic random lines in points that are uniform by area. Lines are drawn through the cubes
of a grid that may hold the surface.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import InvalidInput

Values = NDArray[np.float64]

# As in the core (samplers/surfaces/): cubes of the grid, how often the box is fitted and while what
# share of it goes, and how much more the function may vary in a cube than between its corners.
CUBES = 64**3
FITTINGS = 10
WORTHWHILE = 0.5
VARIATION = 1.5
# A line within a cube, at most 1.73 of its sides long, is looked at in steps of at most a quarter.
STEPS = 7
# The Illinois method: some 8 steps on a smooth function, to this share of the values around a root.
ROOT_STEPS = 40
ROOT_TOLERANCE = 1e-9
PILOT = 20_000
MOST_LINES = 500_000
# Lines at a time: what is made of them stays in the cache. And blocks that find next to nothing.
BLOCK = 8192
MOST_TRIES = 100_000
CORNERS = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])


class ImplicitSampler:
    """Samples of f(x, y, z) = 0 in a box; `lower` and `upper` bound what was found.

    Raises InvalidInput where the box is empty, the function is not finite in it, or there is no
    surface.
    """

    def __init__(
        self, function: Callable[..., Any], lower: Sequence[float], upper: Sequence[float]
    ) -> None:
        self.function = function
        box = np.array([lower, upper], dtype=np.float64)
        for axis in range(3):
            if not box[0, axis] < box[1, axis] or not np.isfinite(box[1, axis] - box[0, axis]):
                raise InvalidInput(f"The box is empty: lower[{axis}] must be below upper[{axis}].")
        self._find_cubes(box)
        pilot = self._intersect(np.random.default_rng(0), PILOT)
        lines = PILOT
        while len(pilot) < PILOT and lines < MOST_LINES:
            pilot = np.vstack([pilot, self._intersect(np.random.default_rng(lines), PILOT)])
            lines += PILOT
        if len(pilot) == 0:
            raise _no_surface()
        self.lines_per_sample = lines / len(pilot)
        self.lower, self.upper = pilot.min(axis=0), pilot.max(axis=0)
        self.pilot = pilot

    def draw(self, random: np.random.Generator, count: int) -> Values:
        """Return samples, (count, 3)."""
        batches: list[Values] = []
        missing, tries = count, 0
        while missing > 0:
            if tries == MOST_TRIES:
                raise InvalidInput(
                    "The surface of the function is too small a part of the box to be sampled: "
                    "make the box smaller."
                )
            lines = min(BLOCK, int(1.1 * self.lines_per_sample * missing) + 16)
            batches.append(self._intersect(random, lines)[:missing])
            missing -= len(batches[-1])
            tries += 1
        return np.vstack(batches) if batches else np.empty((0, 3))

    def _values(self, points: Values) -> Values:
        """The function at points of any leading shape."""
        flat = points.reshape(-1, 3)
        values = np.asarray(self.function(flat[:, 0], flat[:, 1], flat[:, 2]), dtype=np.float64)
        if values.ndim == 0 or values.shape == (1,):
            values = np.broadcast_to(values, len(flat))
        if values.shape != (len(flat),):
            raise InvalidInput(
                f"The function must return as many values as it is given, {len(flat)}, not an "
                f"array of the shape {values.shape}."
            )
        return values.reshape(points.shape[:-1])

    def _find_cubes(self, box: Values) -> None:
        """Lay a grid into the box, then into what is left of it, until it fits the surface."""
        for _ in range(FITTINGS):
            searched = box[1] - box[0]
            box = self._search(box)
            if np.prod(box[1] - box[0]) > WORTHWHILE * np.prod(searched):
                break
        self.box = box

    def _search(self, box: Values) -> Values:
        self.size = _cube_size(box[1] - box[0])
        counts = np.maximum(1, np.ceil((box[1] - box[0]) / self.size).astype(int))
        index = np.stack(np.meshgrid(*map(np.arange, counts + 1), indexing="ij"), axis=-1)
        corners = self._finite(np.minimum(box[0] + index * self.size, box[1]))
        index = index[:-1, :-1, :-1]
        centres = self._finite(np.minimum(box[0] + (index + 0.5) * self.size, box[1]))
        furthest = np.zeros_like(centres)
        for i, j, k in CORNERS:
            part = corners[i : i + counts[0], j : j + counts[1], k : k + counts[2]]
            furthest = np.maximum(furthest, np.abs(part - centres))
        # Where the sign changes, some corner is further from the centre's value than zero is.
        self.cubes = box[0] + index[np.abs(centres) <= VARIATION * furthest] * self.size
        if len(self.cubes) == 0:
            raise _no_surface()
        return np.array(
            [self.cubes.min(axis=0), np.minimum(self.cubes.max(axis=0) + self.size, box[1])]
        )

    def _finite(self, points: Values) -> Values:
        values = self._values(points)
        broken = ~np.isfinite(values)
        if broken.any():
            x, y, z = points[broken][0]
            raise InvalidInput(
                f"The function is not finite at ({x:.6g}, {y:.6g}, {z:.6g}), which is in the box."
            )
        return values

    def _intersect(self, random: np.random.Generator, lines: int) -> Values:
        """Where random lines meet the surface."""
        lowest = self.cubes[random.integers(len(self.cubes), size=lines)]
        origins, directions = _lines_through(lowest, self.size, random)
        begin, end = _stretch_within(
            origins, directions, lowest, np.minimum(lowest + self.size, self.box[1])
        )
        valid = begin < end
        origins, directions = origins[valid], directions[valid]
        shares = np.linspace(0, 1, STEPS + 1)
        times = begin[valid, None] + (end - begin)[valid, None] * shares
        values = self._values(origins[:, None] + times[..., None] * directions[:, None])
        line, step = np.nonzero((values[:, :-1] < 0) != (values[:, 1:] < 0))
        return self._roots(
            origins[line],
            directions[line],
            np.stack([times[line, step], times[line, step + 1]]),
            np.stack([values[line, step], values[line, step + 1]]),
        )

    def _roots(self, origins: Values, directions: Values, times: Values, values: Values) -> Values:
        """The roots between two times each, where values have opposite signs: Illinois method."""
        most = np.abs(values).max(axis=0)
        (a, b), (low, high) = times.copy(), values.copy()
        root, value = b.copy(), high.copy()
        for _ in range(ROOT_STEPS):
            root = np.clip((a * high - b * low) / (high - low), np.minimum(a, b), np.maximum(a, b))
            value = self._values(origins + root[:, None] * directions)
            crosses = (value < 0) != (high < 0)
            a, low = np.where(crosses, b, a), np.where(crosses, high, low / 2)
            b, high = root, value
            if (np.abs(value) <= ROOT_TOLERANCE * most).all():
                break
            high = np.where(high == 0, np.where(low < 0, 1e-300, -1e-300), high)
        # At a pole, the sign changes where there is no root.
        is_root = np.abs(value) <= most
        return (origins + root[:, None] * directions)[is_root]


def _cube_size(extent: Values) -> float:
    """The size at which no more than about CUBES cubes fill the box, thin ones too."""
    a, b, c = np.sort(extent)
    return float(max(np.cbrt(a / CUBES * b * c), np.sqrt(b / CUBES * c), c / CUBES))


def _no_surface() -> InvalidInput:
    return InvalidInput(
        "There is no surface in the box: the function changes its sign nowhere in it."
    )


def _lines_through(
    lowest: Values, size: float, random: np.random.Generator
) -> tuple[Values, Values]:
    """Lines that are as likely as any others that meet the cubes.

    Each enters at a point that is uniform on the cube's sides, with a direction whose density is
    the cosine to the side's normal: its shadow on the side is uniform in a disc.
    """
    count = len(lowest)
    radius, angle = np.sqrt(random.random(count)), 2 * np.pi * random.random(count)
    inwards = np.sqrt(1 - radius**2)
    side = random.integers(6, size=count)
    row, axis, is_far = np.arange(count), side % 3, side >= 3
    origins, directions = lowest.copy(), np.empty((count, 3))
    origins[row, axis] += np.where(is_far, size, 0)
    directions[row, axis] = np.where(is_far, -inwards, inwards)
    for turn, shadow in ((1, np.cos), (2, np.sin)):
        origins[row, (axis + turn) % 3] += size * random.random(count)
        directions[row, (axis + turn) % 3] = radius * shadow(angle)
    return origins, directions


def _stretch_within(
    origins: Values, directions: Values, lower: Values, upper: Values
) -> tuple[Values, Values]:
    """From where to where lines are within boxes, from their origins on; empty: not below."""
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = (lower - origins) / directions, (upper - origins) / directions
    # Along a side: within where the origin is, for ever.
    inside = (lower <= origins) & (origins <= upper)
    still = directions == 0
    near = np.where(still, np.where(inside, -np.inf, np.inf), np.minimum(one, other))
    far = np.where(still, np.inf, np.maximum(one, other))
    return np.maximum(near.max(axis=1), 0), far.min(axis=1)
