# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests do with a document again and again: make one, run the filter, look at layers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pymeshlab
import pytest
from numpy.typing import ArrayLike, NDArray

FILTER = "generate_surface_reconstruction_neural_mesh"
IMPLICIT = "create_neural_mesh_from_implicit_surface"
PARAMETRIC = "create_neural_mesh_from_parametric_surface"

Points = NDArray[np.float64]

# Its name up to 2022.2.
Percentage = getattr(pymeshlab, "PercentageValue", None) or pymeshlab.Percentage


def document_of(points: ArrayLike, label: str = "cloud") -> pymeshlab.MeshSet:
    """Return a document with one layer: the points, shape (n, 3), n at least 1."""
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(np.asarray(points, dtype=np.float64)), label)
    return document


def reconstruct(document: pymeshlab.MeshSet, **parameters: object) -> dict[str, object]:
    """Apply the filter to the current layer and return what it reports."""
    return document.apply_filter(FILTER, **parameters)


def valences_of(faces: NDArray[np.int32], vertex_count: int) -> NDArray[np.int64]:
    """Return entry k: how many vertices of a closed mesh have k neighbours (= k faces)."""
    return np.bincount(np.bincount(faces.ravel(), minlength=vertex_count))


def torus_mesh(
    centre: ArrayLike = (0.0, 0.0, 0.0), major: float = 2.0, minor: float = 1.0
) -> pymeshlab.Mesh:
    """Return a torus around the z axis of 12 by 8 quads, each cut in two: 96 vertices."""
    i, j = (index.ravel() for index in np.meshgrid(np.arange(12), np.arange(8), indexing="ij"))
    a, b = 2 * np.pi * i / 12, 2 * np.pi * j / 8
    ring = major + minor * np.cos(b)
    points = np.column_stack([ring * np.cos(a), ring * np.sin(a), minor * np.sin(b)])
    right, up = (i + 1) % 12, (j + 1) % 8
    here, both = i * 8 + j, right * 8 + up
    faces = np.vstack(
        [
            np.column_stack([here, right * 8 + j, both]),
            np.column_stack([here, both, i * 8 + up]),
        ]
    )
    return pymeshlab.Mesh(points + np.asarray(centre), faces.astype(np.int32))


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
    """Take down the state of a document."""
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
    return DocumentState(layers, document.current_mesh_id() if layers else -1)


def assert_refused(
    document: pymeshlab.MeshSet, sentence: str, filter_name: str = FILTER, **parameters: object
) -> None:
    """Assert that the filter fails with exactly this sentence and touches nothing."""
    before = state_of(document)
    with pytest.raises(pymeshlab.PyMeshLabException) as caught:
        document.apply_filter(filter_name, **parameters)
    assert str(caught.value) == f"Failed to apply filter: {filter_name}\nDetails: {sentence}"
    assert state_of(document) == before
