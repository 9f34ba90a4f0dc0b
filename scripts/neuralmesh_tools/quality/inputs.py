# SPDX-License-Identifier: GPL-3.0-or-later
"""What the methods are given: points of a model, made worse in a reproducible way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from neuralmesh_tools.geometry import Faces, Points, diagonal, sample_surface, vertex_normals
from neuralmesh_tools.quality import models


@dataclass(frozen=True)
class Condition:
    """Noise: a coordinate's standard deviation by the diagonal. Outliers: a share of the count.

    density_ratio: how many times as dense the points are at one end of the longest side as at the
    other. points and vertices: so many instead of the model's own.
    """

    label: str
    noise: float = 0.0
    outliers: float = 0.0
    density_ratio: float = 1.0
    points: int | None = None
    vertices: int | None = None


CONDITIONS: dict[str, Condition] = {
    "clean": Condition("clean"),
    "noise0.2": Condition("σ = 0.2 %", noise=0.002),
    "noise0.5": Condition("σ = 0.5 %", noise=0.005),
    "noise1": Condition("σ = 1 %", noise=0.01),
    "outliers": Condition("σ = 0.5 % + 5 % outliers", noise=0.005, outliers=0.05),
    "uneven": Condition("density 10 : 1", density_ratio=10),
    "sparse": Condition("3,000 points, 1,500 vertices", points=3_000, vertices=1_500),
}

OUTLIER_BOX_GROWTH = 0.10


@dataclass(frozen=True)
class Case:
    """Points (n, 3), their true unit normals (n, 3), and the surface they came from."""

    points: Points
    normals: Points
    reference_points: Points
    reference_faces: Faces


def make_case(model: str, condition: str, seed: int) -> Case:
    """Build the input of a row; the same three arguments always give the same numbers.

    A noisy point keeps the normal of the point it was. An outlier lies anywhere in the bounding
    box enlarged by 10 % and has a random normal: it has no true one.
    """
    reference_points, reference_faces = models.load(model)
    how = CONDITIONS[condition]
    count = how.points or models.MODELS[model].samples
    if count or how.density_ratio != 1:
        drawing = np.random.default_rng([seed, 0])
        density = ramp(reference_points, reference_faces, how.density_ratio)
        points, normals = sample_surface(
            reference_points, reference_faces, count or len(reference_points), drawing, density
        )
    else:
        points = reference_points
        normals = vertex_normals(reference_points, reference_faces)
    generator = np.random.default_rng([seed, 1])
    worse = worsened(points, reference_points, how, generator)
    strays = len(worse) - len(points)
    directions = generator.normal(size=(strays, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return Case(worse, np.vstack([normals, directions]), reference_points, reference_faces)


def ramp(points: Points, faces: Faces, ratio: float) -> Points:
    """Densities (m,) of faces that rise to ratio times along the longest side, exponentially."""
    axis = int(np.argmax(np.ptp(points, axis=0)))
    along = points[faces, axis].mean(axis=1)
    share = (along - points[:, axis].min()) / np.ptp(points[:, axis])
    densities: Points = ratio**share
    return densities


def worsened(
    points: Points, extent: Points, condition: Condition, generator: np.random.Generator
) -> Points:
    """Return the points with the condition's noise, followed by its outliers.

    extent: points whose bounding box says how large the noise is and where outliers lie.
    """
    if condition.noise:
        sigma = condition.noise * diagonal(extent)
        points = points + generator.normal(scale=sigma, size=points.shape)
    low, high = extent.min(axis=0), extent.max(axis=0)
    size = high - low
    # Outliers of a plane lie beside it too: the box grows across it as it does along it.
    margin = OUTLIER_BOX_GROWTH / 2 * np.where(size > 0, size, size.max())
    count = round(condition.outliers * len(points))
    return np.vstack([points, generator.uniform(low - margin, high + margin, size=(count, 3))])
