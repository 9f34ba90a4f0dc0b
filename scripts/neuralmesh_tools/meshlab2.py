# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes filters.json, which declares our filters to MeshLab's rewrite, out of the built plugin.

    PYTHONPATH=scripts .venv/bin/python -m neuralmesh_tools.meshlab2

Names, texts and defaults are the plugin's own; what that host asks for besides stands here.
"""

from __future__ import annotations

import ctypes
import json
import sys
from typing import Any

from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.project import PLUGIN, ROOT, require_plugin

FILE = ROOT / "filter_neuralmesh/hosts/meshlab2/filters.json"
PLUGIN_ID = "meshlab2.filter.neuralmesh"
PAPER = {
    "id": "ivrissimtzis2003growing",
    "type": "paper-conference",
    "title": "Using Growing Cell Structures for Surface Reconstruction",
    "author": [
        {"family": "Ivrissimtzis", "given": "Ioannis"},
        {"family": "Jeong", "given": "Won-Ki"},
        {"family": "Seidel", "given": "Hans-Peter"},
    ],
    "container-title": "Shape Modeling International",
    "issued": {"date-parts": [[2003]]},
}
# Of the plugin's filters: what the host calls them, where it lists them, and what they are.
FILTERS: dict[str, dict[str, Any]] = {
    "generate_surface_reconstruction_neural_mesh": {
        "id": "reconstruct_surface_by_neural_mesh",
        "name": "Reconstruct Surface by Neural Mesh",
        "categories": ["Creation/Reconstruction"],
        "shortDescription": "Creates a mesh of an exact number of vertices from points.",
        "longDescriptionMarkdown": (
            "A growing neural network that is itself the mesh: it starts as a coarse mesh of the "
            "points' shape, random samples of the points pull it towards them, and it grows by "
            "splitting the vertices that are nearest to most samples. It needs no normals.\n\n"
            "The result has the handles and parts of the points, and is closed or, if you like, "
            "open where there are none. The running time depends on the number of its vertices, "
            "not on that of the points."
        ),
    },
    "create_neural_mesh_from_implicit_surface": {
        "id": "create_neural_mesh_from_implicit_surface",
        "name": "Create Neural Mesh from Implicit Surface",
        "categories": ["Creation/Primitives"],
        "shortDescription": "Creates a mesh of an exact size of an implicit surface.",
        "longDescriptionMarkdown": (
            "Meshes the zeros of an expression in x, y and z within a box, by the growing neural "
            "network of *Reconstruct Surface by Neural Mesh*."
        ),
    },
    "create_neural_mesh_from_parametric_surface": {
        "id": "create_neural_mesh_from_parametric_surface",
        "name": "Create Neural Mesh from Parametric Surface",
        "categories": ["Creation/Primitives"],
        "shortDescription": "Creates a mesh of an exact size of a parametric surface.",
        "longDescriptionMarkdown": (
            "Meshes the surface that three expressions in u and v describe, by the growing neural "
            "network of *Reconstruct Surface by Neural Mesh*."
        ),
    },
}
# Ids are our names with a small first letter; PyMeshLab has all letters small.
NAMES = """
    targetVertNum source pointFile topology boundaries maxHoleSize snapshots surfaceFit randomSeed
    transferAttributes startMesh startLayer densityFromQuality threads timeLimit winnerRate
    smoothingRate smoothingPasses signalsPerSplit inactivityFactor counterDecay splitRule edgeFlips
    expr minX minY minZ maxX maxY maxZ x y z minU maxU minV maxV
"""
IDS = {name.lower(): name for name in NAMES.split()}
# Options in the order of the plugin's choices.
OPTIONS = {
    "source": ["points", "surface", "visible_layers", "point_file"],
    "topology": ["of_start", "learned"],
    "boundaries": ["closed", "open"],
    "startMesh": ["tetrahedron", "octahedron", "icosahedron", "a_layer", "from_data"],
    "splitRule": ["balanced", "paper"],
}
MOST = 2**31 - 1
RANGES: dict[str, tuple[float, float]] = {
    "targetVertNum": (4, MOST),
    "maxHoleSize": (0, 100),
    "randomSeed": (0, MOST),
    "threads": (0, 256),
    "timeLimit": (0, 1_000_000),
    "winnerRate": (0, 1),
    "smoothingRate": (0, 1),
    "smoothingPasses": (1, 100),
    "signalsPerSplit": (1, 10_000),
    "inactivityFactor": (1, MOST),
    "counterDecay": (0, 1),
}
DECIMALS = 6
# Where the host differs from those of today.
OTHERWISE: dict[str, dict[str, Any]] = {
    "targetVertNum": {
        "help": "Exact number of vertices of the result, at least 4 and at most the number of "
        "distinct input points. A closed mesh of genus 0 has twice as many faces, less 4."
    },
    # The document's box is not that of what is sampled, so no length is asked for.
    "maxHoleSize": {
        "default": 10.0,
        "help": "Smaller gaps in the data are closed. In per cent of the diagonal of the bounding "
        "box of what is sampled. Without effect unless the topology is learned.",
    },
    # The host's convention for all filters that draw random numbers.
    "randomSeed": {
        "default": 0,
        "help": "Zero draws a fresh seed on every run, which is reported; any other value makes "
        "the mesh exactly reproducible.",
    },
    "startLayer": {"default": "@currentMeshIndex", "meshAllowsNone": True},
    "pointFile": {"fileNameFilters": ["Point files (*.ply *.las *.npy)"]},
}
TYPES = {"startLayer": "mesh", "pointFile": "fileopen", "maxHoleSize": "double"}


def declarations() -> dict[str, Any]:
    """What filters.json holds. Loads the plugin into PyMeshLab."""
    import pymeshlab

    plugin = str(require_plugin(PLUGIN))
    library = ctypes.CDLL(plugin)
    library.neuralmesh_documentation.restype = ctypes.c_char_p
    described = json.loads(library.neuralmesh_documentation())
    if described[0]["name"] not in pymeshlab.filter_list():
        pymeshlab.load_plugin(plugin)
    document = pymeshlab.MeshSet(verbose=False)
    document.create_sphere(subdiv=6)  # of more points than twice the default of the target
    filters = []
    for filter_ in described:
        defaults = document.filter_parameter_values(filter_["name"])
        filters.append(
            {
                **FILTERS[filter_["name"]],
                "pythonName": FILTERS[filter_["name"]]["id"],
                "referenceIds": [PAPER["id"]],
                "tags": ["reconstruction", "surface", "point cloud", "neural", "manifold"],
                "inputDomain": "None",  # a file, all visible layers or the current one
                "outputDomain": "NewMeshes",
                "outputTag": "neural mesh",
                "parameters": [_parameter(each, defaults) for each in filter_["parameters"]],
            }
        )
    return {"pluginId": PLUGIN_ID, "references": [PAPER], "filters": filters}


def _parameter(described: dict[str, Any], defaults: dict[str, Any]) -> dict[str, Any]:
    name = IDS[described["name"]]
    default = defaults[described["name"]]
    options = OPTIONS.get(name)
    kind = {bool: "bool", int: "int", float: "double", str: "string"}[type(default)]
    declared: dict[str, Any] = {
        "id": name,
        "label": described["title"],
        "help": described["help"],
        "group": "advanced" if described["advanced"] else "main",
        "type": "enum" if options else TYPES.get(name, kind),
        "default": float(f"{default:.9g}") if isinstance(default, float) else default,
    }
    if options:
        declared["default"] = options[default]
        declared["enumOptions"] = [
            {"id": option, "label": label}
            for option, label in zip(options, described["choices"], strict=True)
        ]
    if name in RANGES:
        declared["min"], declared["max"] = RANGES[name]
    if declared["type"] == "double":
        declared["decimals"] = DECIMALS
    return declared | OTHERWISE.get(name, {})


def text() -> str:
    """The content of filters.json: a parameter a line, in the host's spelling."""
    declared = declarations()
    filters = ",\n".join(
        "    {\n"
        + "".join(f"      {_line(key, filter_[key])},\n" for key in filter_ if key != "parameters")
        + '      "parameters": [\n'
        + ",\n".join(f"        {_json(each)}" for each in filter_["parameters"])
        + "\n      ]\n    }"
        for filter_ in declared["filters"]
    )
    head = "".join(f"  {_line(key, declared[key])},\n" for key in ("pluginId", "references"))
    return f'{{\n{head}  "filters": [\n{filters}\n  ]\n}}\n'


def _line(key: str, value: object) -> str:
    return f"{_json(key)}: {_json(value)}"


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False).replace("olour", "olor")


if __name__ == "__main__":
    write_in_one_step(FILE, text())
    print(FILE)
    sys.exit(0)
