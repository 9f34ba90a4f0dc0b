# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of cases, by the package and by the plugin: a mesh with what is told of it, or a refusal."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.properties.inputs import Case


@dataclass(frozen=True)
class Run:
    """What became of a case: a sentence if it was refused, else meshes and figures."""

    refusal: str = ""
    vertices: Points | None = None
    faces: Faces | None = None
    info: dict[str, Any] = field(default_factory=dict)
    snapshots: tuple[tuple[Points, Faces], ...] = ()


def by_package(case: Case) -> Run:
    """Run a case by `neuralmesh.reconstruct`."""
    import neuralmesh

    try:
        made = neuralmesh.reconstruct(case.recipe.points(), **case.parameters)
    except neuralmesh.InvalidInput as refusal:
        return Run(str(refusal))
    snapshots = tuple((mesh.vertices, mesh.faces) for mesh in made.snapshots)
    return Run("", made.vertices, made.faces, made.info, snapshots)


def by_plugin(case: Case) -> Run:
    """Run a case by the plugin in PyMeshLab. The document may hold no more than it says."""
    import pymeshlab

    from neuralmesh_tools.layers import arrays_of, details, document_of, load_plugin
    from neuralmesh_tools.project import PLUGIN

    load_plugin(PLUGIN)
    document = document_of(case.recipe.points().astype(float))
    try:
        info = document.apply_filter(
            "generate_surface_reconstruction_neural_mesh", **case.parameters
        )
    except pymeshlab.PyMeshLabException as refusal:
        assert document.mesh_number() == 1, "a refusal left a layer"
        return Run(details(refusal))
    layers = [arrays_of(document, mesh.id()) for mesh in document][1:]
    vertices, faces = layers.pop()
    return Run("", vertices, faces, info, tuple(layers))
