# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests do with a document again and again: make one, run the filter, look at layers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pymeshlab
from numpy.typing import ArrayLike, NDArray

FILTER = "generate_surface_reconstruction_neural_mesh"

Points = NDArray[np.float64]


def document_of(points: ArrayLike, label: str = "cloud") -> pymeshlab.MeshSet:
    """Return a document with one layer: the points, shape (n, 3), n at least 1."""
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(np.asarray(points, dtype=np.float64)), label)
    return document


def reconstruct(document: pymeshlab.MeshSet, **parameters: object) -> dict[str, object]:
    """Apply the filter to the current layer and return what it reports."""
    return document.apply_filter(FILTER, **parameters)


def mesh_from(points: ArrayLike, **parameters: object) -> tuple[Points, NDArray[np.int32]]:
    """Reconstruct the points in a document of their own; return vertices and faces."""
    document = document_of(points)
    reconstruct(document, **parameters)
    mesh = document.current_mesh()
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())


def sphere_points(count: int, seed: int = 0) -> Points:
    """Return random points on the unit sphere, shape (count, 3)."""
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]


@dataclass(frozen=True)
class Layer:
    """All of a layer that a filter could have touched by mistake."""

    id: int
    label: str
    vertices: bytes
    faces: bytes
    matrix: bytes


@dataclass(frozen=True)
class DocumentState:
    """A document's layers and which one is current; equal states mean an untouched document."""

    layers: tuple[Layer, ...]
    current: int


def state_of(document: pymeshlab.MeshSet) -> DocumentState:
    """Take down the state of a document that has a current layer."""
    layers = tuple(
        Layer(
            mesh.id(),
            mesh.label(),
            mesh.vertex_matrix().tobytes(),
            mesh.face_matrix().tobytes(),
            mesh.transform_matrix().tobytes(),
        )
        for mesh in document
    )
    return DocumentState(layers, document.current_mesh_id())
