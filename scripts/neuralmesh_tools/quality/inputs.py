# SPDX-License-Identifier: GPL-3.0-or-later
"""What the methods are given: points of a model, made worse in a reproducible way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from neuralmesh_tools.geometry import Faces, Points, diagonal, sample_surface, vertex_normals
from neuralmesh_tools.quality import models


@dataclass(frozen=True)
class Condition:
    """Noise: a coordinate's standard deviation by the diagonal. Outliers: a share of the count."""

    label: str
    noise: float = 0.0
    outliers: float = 0.0


CONDITIONS: dict[str, Condition] = {
    "clean": Condition("clean"),
    "noise0.2": Condition("σ = 0.2 %", noise=0.002),
    "noise0.5": Condition("σ = 0.5 %", noise=0.005),
    "outliers": Condition("σ = 0.5 % + 5 % outliers", noise=0.005, outliers=0.05),
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
    count = models.MODELS[model].samples
    if count:
        drawing = np.random.default_rng([seed, 0])
        points, normals = sample_surface(reference_points, reference_faces, count, drawing)
    else:
        points = reference_points
        normals = vertex_normals(reference_points, reference_faces)
    generator = np.random.default_rng([seed, 1])
    worse = worsened(points, reference_points, CONDITIONS[condition], generator)
    strays = len(worse) - len(points)
    directions = generator.normal(size=(strays, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return Case(worse, np.vstack([normals, directions]), reference_points, reference_faces)


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
