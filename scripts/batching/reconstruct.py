# SPDX-License-Identifier: GPL-3.0-or-later
"""One scan through a recipe, from file to file, in an isolated process: it may crash or hang."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab

from batching.recipe import Recipe, Value


def reconstruct(recipe: Recipe, source: str, target: str) -> dict[str, Any]:
    """Load source, follow the recipe, save the layer that is then current as target.

    Returns the number of vertices and faces, and what the filter returned. Raises ValueError with
    a sentence for the user.
    """
    load_plugins(recipe.plugins)
    document = pymeshlab.MeshSet(verbose=False)
    load(document, source)
    returned = follow(document, recipe)
    mesh = document.current_mesh()
    results = {"vertices": mesh.vertex_number(), "faces": mesh.face_number()}
    if results["vertices"] == 0:
        raise ValueError("The result is an empty mesh.")
    document.save_current_mesh(target)
    return {**results, **{name: _plain(value) for name, value in (returned or {}).items()}}


@cache
def load_plugins(paths: tuple[str, ...]) -> None:
    """Load plugins, once a process."""
    for path in paths:
        pymeshlab.load_plugin(path)


def load(document: pymeshlab.MeshSet, source: str) -> None:
    """Read a scan into a document; raises ValueError if it cannot be read or is empty."""
    path = Path(source)
    if not path.exists():
        raise ValueError("There is no such file.")
    if not path.is_file():
        raise ValueError("It is not a file.")
    try:
        document.load_new_mesh(source)
    except pymeshlab.PyMeshLabException as problem:
        raise ValueError(f"It cannot be read: {details(problem)}") from None
    if document.current_mesh().vertex_number() == 0:
        raise ValueError("It holds no points.")


def follow(document: pymeshlab.MeshSet, recipe: Recipe) -> dict[str, Any] | None:
    """Apply the recipe to the current layer and return what the filter returned, if anything."""
    try:
        if recipe.script:
            script = Path("recipe.mlx")
            script.write_text(recipe.script, encoding="utf-8")
            document.load_filter_script(str(script))
            script.unlink()
            return document.apply_filter_script()
        parameters = {name: _pymeshlab(value) for name, value in recipe.parameters.items()}
        if "threads" in document.filter_parameter_values(recipe.filter):
            parameters.setdefault("threads", recipe.threads)
        return document.apply_filter(recipe.filter, **parameters)
    except pymeshlab.PyMeshLabException as problem:
        raise ValueError(details(problem)) from None


def details(problem: Exception) -> str:
    """The part of PyMeshLab's words that says what is wrong, as a sentence."""
    words = " ".join(str(problem).split("etails:")[-1].split()) or type(problem).__name__
    return words if words.endswith(".") else words + "."


def _pymeshlab(value: Value) -> Any:
    if isinstance(value, str) and value.endswith("%"):
        return pymeshlab.PercentageValue(float(value[:-1]))
    return value


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value
