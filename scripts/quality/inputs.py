"""What the methods are given: points of a model, made worse in a reproducible way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from datasets import Faces, Points

from quality import models


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


def diagonal(points: Points) -> float:
    """The length of the bounding box diagonal, in the points' units."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def face_normals(points: Points, faces: Faces) -> Points:
    """Normals (m, 3) of faces, twice the face's area long."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    normals: Points = np.cross(b - a, c - a)
    return normals


def sample_surface(
    points: Points, faces: Faces, count: int, generator: np.random.Generator
) -> tuple[Points, Points]:
    """Draw points (count, 3) uniformly by area, and the unit normals (count, 3) of their faces."""
    normals = face_normals(points, faces)
    doubled_area = np.linalg.norm(normals, axis=1)
    chosen = generator.choice(len(faces), size=count, p=doubled_area / doubled_area.sum())
    root, along = np.sqrt(generator.random(count))[:, None], generator.random(count)[:, None]
    a, b, c = (points[faces[chosen, k]] for k in range(3))
    drawn = (1 - root) * a + root * (1 - along) * b + root * along * c
    return drawn, normals[chosen] / doubled_area[chosen, None]


def vertex_normals(points: Points, faces: Faces) -> Points:
    """Area-weighted unit normals (n, 3) of vertices."""
    normals = np.zeros_like(points)
    of_faces = face_normals(points, faces)
    for k in range(3):
        np.add.at(normals, faces[:, k], of_faces)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    return normals


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
    settings = CONDITIONS[condition]
    generator = np.random.default_rng([seed, 1])
    if settings.noise:
        sigma = settings.noise * diagonal(reference_points)
        points = points + generator.normal(scale=sigma, size=points.shape)
    if settings.outliers:
        stray, strays_normals = _outliers(
            reference_points, round(settings.outliers * len(points)), generator
        )
        points, normals = np.vstack([points, stray]), np.vstack([normals, strays_normals])
    return Case(points, normals, reference_points, reference_faces)


def _outliers(
    reference: Points, count: int, generator: np.random.Generator
) -> tuple[Points, Points]:
    low, high = reference.min(axis=0), reference.max(axis=0)
    margin = OUTLIER_BOX_GROWTH / 2 * (high - low)
    points = generator.uniform(low - margin, high + margin, size=(count, 3))
    directions = generator.normal(size=(count, 3))
    return points, directions / np.linalg.norm(directions, axis=1, keepdims=True)
