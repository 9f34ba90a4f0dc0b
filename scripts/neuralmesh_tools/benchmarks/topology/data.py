# SPDX-License-Identifier: GPL-3.0-or-later
"""The data of the topology table: points, clean or made worse, and the surface they are of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from neuralmesh_tools import datasets, generated_clouds
from neuralmesh_tools.geometry import Faces, Points, sample_surface
from neuralmesh_tools.layers import arrays_of, read_document
from neuralmesh_tools.quality import inputs
from neuralmesh_tools.quality.inputs import Condition

SURFACE_SAMPLES = 100_000
SPARSE_POINTS = 3_000
SPARSE_VERTICES = 1_500
# Of the half at the low end of the longest side, one in so many stays.
HALF_RATIO = 10

# The quality table's outliers come with noise; these come alone.
CONDITIONS: dict[str, Condition] = {
    "clean": Condition("clean"),
    "noise": inputs.CONDITIONS["noise0.2"],
    "outliers": Condition("5 % outliers", outliers=0.05),
    "sparse": Condition(f"{SPARSE_POINTS:,} points"),
    "half": Condition(f"one half {HALF_RATIO} : 1"),
}


@dataclass(frozen=True)
class Cloud:
    """Points (n, 3) of a surface: as they are given, and before they were made worse.

    surface: what they are of, as a mesh, where there is one. zeros: so many returns at the origin
    among the points given, not among the clean ones.
    """

    points: Points
    clean: Points
    surface: tuple[Points, Faces] | None = None
    zeros: int = 0


# A cloud of so many points with a seed; the same two arguments always give the same cloud.
Maker = Callable[[int, int], Cloud]


def made(maker: Maker, count: int, condition: str, seed: int) -> Cloud:
    """Return a maker's cloud in a condition; sparse means SPARSE_POINTS instead of count.

    Raises datasets.Unavailable if its model cannot be had.
    """
    cloud = maker(SPARSE_POINTS if condition == "sparse" else count, seed)
    generator = np.random.default_rng([seed, 1])
    points = inputs.worsened(cloud.clean, cloud.clean, CONDITIONS[condition], generator)
    if condition == "half":
        points = with_sparse_half(points, generator)
    return replace(cloud, points=np.vstack([points, np.zeros((cloud.zeros, 3))]))


def with_sparse_half(points: Points, generator: np.random.Generator) -> Points:
    """Take nine in ten points (n, 3) out of the half at the low end of the longest side."""
    along = points[:, int(np.argmax(np.ptp(points, axis=0)))]
    kept: Points = points[
        (along >= np.median(along)) | (generator.random(len(points)) < 1 / HALF_RATIO)
    ]
    return kept


def generated(generate: Callable[[int, int], Points]) -> Maker:
    """Return a maker of points that a function of count and seed generates."""

    def maker(count: int, seed: int) -> Cloud:
        points = np.asarray(generate(count, seed), dtype=np.float64)
        return Cloud(points, points)

    return maker


def sampled(load: Callable[[], tuple[Points, Faces]]) -> Maker:
    """Return a maker of points drawn uniformly by area from a surface."""

    def maker(count: int, seed: int) -> Cloud:
        points, faces = load()
        drawn, _ = sample_surface(points, faces, count, np.random.default_rng([seed, 0]))
        return Cloud(drawn, drawn, (points, faces))

    return maker


def model(name: str) -> Maker:
    """Return a maker of points drawn from a public model."""
    return sampled(lambda: _loaded(name))


def scan(name: str) -> Maker:
    """Return a maker of a public data set's own points: all, or a random part of them."""

    def maker(count: int, seed: int) -> Cloud:
        points, _ = arrays_of(read_document(datasets.fetch(name)))
        if count < len(points):
            generator = np.random.default_rng([seed, 0])
            points = points[generator.choice(len(points), size=count, replace=False)]
        surface = _loaded(name)
        return Cloud(points, points, surface if len(surface[1]) else None)

    return maker


def ball_with_zeros(offset: tuple[float, float, float], zeros: int) -> Maker:
    """Return a maker of a unit ball's surface at an offset, with so many returns at the origin."""

    def maker(count: int, seed: int) -> Cloud:
        ball = generated_clouds.sphere(count, seed) + np.array(offset)
        return Cloud(ball, ball, zeros=zeros)

    return maker


@cache
def _loaded(name: str) -> tuple[Points, Faces]:
    return datasets.load(name)
