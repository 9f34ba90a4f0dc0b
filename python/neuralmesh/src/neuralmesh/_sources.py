# SPDX-License-Identifier: GPL-3.0-or-later
"""Target spaces: what the network may learn, besides arrays of points and files."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Function = Callable[..., Any]


@dataclass(frozen=True, eq=False)
class Surface:
    """The surface of a mesh, sampled uniformly by area. The triangles may be any set."""

    vertices: ArrayLike
    """(N, 3)"""
    faces: ArrayLike
    """(M, 3), numbers of vertices"""


@dataclass(frozen=True)
class ImplicitSurface:
    """The surface on which a function of x, y and z is zero, within a box, uniform by area.

    The function is an expression in the syntax of muParser, such as "x*x + y*y + z*z - 0.5", as in
    MeshLab's filters; or a Python callable f(x, y, z) that is given three arrays of one length and
    returns as many values. It must change its sign at the surface and be finite in the box.
    Features smaller than 1/64 of the box may be missed.
    """

    function: str | Function
    lower: Sequence[float] = (-1.0, -1.0, -1.0)
    upper: Sequence[float] = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class ParametricSurface:
    """The surface that x, y and z as functions of u and v describe, uniform by area.

    Three expressions in the syntax of muParser, or one Python callable f(u, v) that is given two
    arrays of one length and returns three: x, y and z.
    """

    coordinates: tuple[str, str, str] | Function
    u: tuple[float, float] = (0.0, 2 * math.pi)
    v: tuple[float, float] = (0.0, math.pi)


@runtime_checkable
class Sampler(Protocol):
    """A target space of your own: a probability distribution in space.

    `lower` and `upper` are the corners of a box that holds it. `draw` returns `count` independent
    samples, (count, 3), and takes all its randomness from the generator: then the same seed gives
    the same mesh. It is called with thousands of samples at a time, on another thread.
    """

    @property
    def lower(self) -> Sequence[float]:
        """The least x, y and z."""
        ...

    @property
    def upper(self) -> Sequence[float]:
        """The greatest x, y and z."""
        ...

    def draw(self, random: np.random.Generator, count: int) -> NDArray[np.float64]:
        """Return samples."""
        ...
