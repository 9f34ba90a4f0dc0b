# SPDX-License-Identifier: GPL-3.0-or-later
"""Our runs for the paper's table and figures."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pymeshlab

from neuralmesh_tools import datasets
from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.layers import arrays_of, document_of
from neuralmesh_tools.paper.reported import MODELS, Counts, Model
from neuralmesh_tools.project import FROM_IMPLICIT, RECONSTRUCT

SPHERE = {"expr": "x*x+y*y+z*z-0.5"} | {
    f"{end}{axis}": value for end, value in (("min", -1.0), ("max", 1.0)) for axis in "xyz"
}


@dataclass(frozen=True)
class Setting:
    """Parameters of the filters, with a name for the reader."""

    title: str
    parameters: dict[str, object] = field(default_factory=dict)


PAPERS = Setting(
    "as in the paper",
    {
        "topology": 0,
        "splitrule": 1,
        "edgeflips": False,
        "surfacefit": False,
        "inactivityfactor": 20,
    },
)
DEFAULTS = Setting("our defaults")
SETTINGS = (PAPERS, DEFAULTS)


@dataclass(frozen=True)
class Mesh:
    """A result: vertices (n, 3) and faces (m, 3)."""

    vertices: Points
    faces: Faces


def _document(model: Model) -> pymeshlab.MeshSet:
    """A document with the model as its only layer; empty for the sphere. Raises Unavailable."""
    if not model.dataset:
        return pymeshlab.MeshSet(verbose=False)
    return document_of(*datasets.load(model.dataset), label=model.dataset)


def _apply(
    model: Model, setting: Setting, **parameters: object
) -> tuple[pymeshlab.MeshSet, dict[str, object]]:
    document = _document(model)
    if model.dataset:
        where: dict[str, object] = {"source": model.source}
        result = document.apply_filter(RECONSTRUCT, **where, **setting.parameters, **parameters)
    else:
        result = document.apply_filter(FROM_IMPLICIT, **SPHERE, **setting.parameters, **parameters)
    return document, result


def valence_counts(model: str, vertices: int, setting: Setting) -> Counts:
    """Return how many vertices of a result have 4, 5, 6, 7, 8 and another number of neighbours."""
    _, result = _apply(MODELS[model], setting, targetvertnum=vertices)
    histogram = np.asarray(result["valence_histogram"], dtype=int)
    named = [int(histogram[k]) if k < len(histogram) else 0 for k in range(4, 9)]
    return named[0], named[1], named[2], named[3], named[4], int(histogram.sum()) - sum(named)


def growing_meshes(model: str, counts: list[int], setting: Setting) -> dict[int, Mesh]:
    """Return the network at each of these vertex counts, all from one run, by its snapshots."""
    *on_the_way, target = sorted(set(counts))
    document, _ = _apply(
        MODELS[model],
        setting,
        targetvertnum=target,
        snapshots=",".join(map(str, on_the_way)),
    )
    results = [mesh for mesh in document if "neural mesh" in mesh.label()]
    meshes = {mesh.vertex_number(): Mesh(*arrays_of(document, mesh.id())) for mesh in results}
    missing = set(counts) - set(meshes)
    if missing:
        raise RuntimeError(f"{model}: no mesh of {', '.join(map(str, sorted(missing)))} vertices")
    return meshes
