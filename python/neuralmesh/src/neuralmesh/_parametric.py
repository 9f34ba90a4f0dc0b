# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples of the surface that a Python function of u and v describes, uniform by area.

As in the core's ParametricSampler: a cell of a grid is drawn in proportion to a bound of its area,
and a place in it is kept in proportion to the density of area there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import InvalidInput

Values = NDArray[np.float64]

# As in the core: cells along each parameter, measured at three nodes each way; a bound of a cell's
# density in the largest of them; the step of differences, as a share of the range.
CELLS = 128
BOUND = 1.5
DIFFERENCE = 1e-5
MOST_TRIES = 10_000


class ParametricSampler:
    """Samples of a surface; `lower` and `upper` are bounds of its nodes.

    Raises InvalidInput where a range is empty, the function is not finite, or there is no area.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        u: tuple[float, float],
        v: tuple[float, float],
    ) -> None:
        self.function = function
        for name, (low, high) in (("u", u), ("v", v)):
            if not low < high or not np.isfinite(high - low):
                raise InvalidInput(
                    f"The range of {name.upper()} is empty: {name}[0] must be below {name}[1]."
                )
        self.ranges = np.array([u, v], dtype=np.float64)
        shares = np.linspace(0, 1, 2 * CELLS + 1)
        nodes = np.stack(np.meshgrid(shares, shares, indexing="ij"), axis=-1).reshape(-1, 2)
        self.pilot = self._places(nodes)
        self.lower, self.upper = self.pilot.min(axis=0), self.pilot.max(axis=0)
        density = self._densities(nodes).reshape(2 * CELLS + 1, 2 * CELLS + 1)
        most = np.zeros((CELLS, CELLS))
        for i in range(3):
            for j in range(3):
                part = density[i : i + 2 * CELLS - 1 : 2, j : j + 2 * CELLS - 1 : 2]
                most = np.maximum(most, BOUND * part)
        self.most = most.ravel()
        self.cumulated = np.cumsum(self.most)
        if not self.cumulated[-1] > 0:
            raise InvalidInput("The surface has no area.")

    def draw(self, random: np.random.Generator, count: int) -> Values:
        """Return samples, (count, 3)."""
        batches: list[Values] = []
        missing = count
        for _ in range(MOST_TRIES):
            if missing <= 0:
                break
            # On a smooth surface, two of three are kept.
            tried = int(1.6 * missing) + 16
            cells = np.searchsorted(
                self.cumulated, random.random(tried) * self.cumulated[-1], side="right"
            )
            cells = np.minimum(cells, len(self.most) - 1)
            corner = np.stack([cells // CELLS, cells % CELLS], axis=-1)
            shares = (corner + random.random((tried, 2))) / CELLS
            kept = random.random(tried) * self.most[cells] < self._densities(shares)
            batches.append(self._places(shares[kept][:missing]))
            missing -= len(batches[-1])
        return np.vstack(batches) if batches else np.empty((0, 3))

    def _places(self, shares: Values) -> Values:
        """The surface at shares of the ranges of u and v, (n, 2)."""
        u, v = (self.ranges[:, 0] + (self.ranges[:, 1] - self.ranges[:, 0]) * shares).T
        coordinates = self.function(u, v)
        if len(coordinates) != 3:
            raise InvalidInput("The function must return three arrays: x, y and z.")
        places = np.stack(
            [np.broadcast_to(np.asarray(c, dtype=np.float64), u.shape) for c in coordinates],
            axis=-1,
        )
        broken = ~np.isfinite(places).all(axis=1)
        if broken.any():
            first = int(np.flatnonzero(broken)[0])
            raise InvalidInput(
                f"The function is not finite at u = {u[first]:.6g}, v = {v[first]:.6g}."
            )
        return places

    def _densities(self, shares: Values) -> Values:
        """Area for a share of both ranges, by differences."""
        derivatives = []
        for along in range(2):
            step = np.zeros(2)
            step[along] = DIFFERENCE
            low, high = np.maximum(shares - step, 0), np.minimum(shares + step, 1)
            width = (high - low)[:, along, None]
            derivatives.append((self._places(high) - self._places(low)) / width)
        return np.linalg.norm(np.cross(*derivatives), axis=1)
