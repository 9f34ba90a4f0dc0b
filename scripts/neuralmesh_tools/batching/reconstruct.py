# SPDX-License-Identifier: GPL-3.0-or-later
"""One scan through a recipe, from file to file, in an isolated process: it may crash or hang."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pymeshlab

from neuralmesh_tools.batching.per_cent import with_per_cent
from neuralmesh_tools.batching.recipe import Recipe, Value
from neuralmesh_tools.geometry import diagonal
from neuralmesh_tools.layers import (
    details,
    figures_of,
    load_plugin,
    read_document,
    why_no_points,
)

# What PyMeshLab writes and reads with the same numbers of vertices and faces.
READ_AGAIN = (".ply", ".obj", ".off")


def reconstruct(recipe: Recipe, source: str, target: str) -> dict[str, Any]:
    """Load source, follow the recipe, save the layer that is then current as target.

    Returns the number of vertices and faces, and what the filter returned. Raises ValueError with
    a sentence for the user.
    """
    load_plugins(recipe.plugins)
    document = load(Path(source))
    size = diagonal(document.current_mesh().vertex_matrix())
    returned = follow(document, recipe)
    mesh = document.current_mesh()
    results = {"vertices": mesh.vertex_number(), "faces": mesh.face_number()}
    if results["vertices"] == 0:
        raise ValueError("The result is an empty mesh.")
    save(document, Path(target))
    return {**results, **with_per_cent(figures_of(returned), size)}


def load_plugins(paths: tuple[Path, ...]) -> None:
    """Load plugins, once a process."""
    for path in paths:
        load_plugin(path)


def load(source: Path) -> pymeshlab.MeshSet:
    """Read a scan into a document; raises ValueError if it cannot be read or is empty."""
    try:
        if not source.exists():
            raise ValueError("There is no such file.")
        if not source.is_file():
            raise ValueError("It is not a file.")
    except OSError as problem:  # such as a name that is too long
        raise ValueError(f"It cannot be read: {problem.strerror}.") from None
    document = read_document(source, verbose=True)  # what filters print goes into the log
    if document.current_mesh().vertex_number() == 0:
        raise ValueError(why_no_points(source))
    return document


def save(document: pymeshlab.MeshSet, target: Path) -> None:
    """Save the current layer; raises ValueError if the file is not there whole afterwards.

    A disk that is full as the last block is written goes unnoticed by PyMeshLab: what it wrote is
    read again, where it reads all that it writes.
    """
    counts = counts_again = _counts(document)
    try:
        document.save_current_mesh(str(target))
        if target.suffix in READ_AGAIN:
            counts_again = _counts(read_document(target))
    except (pymeshlab.PyMeshLabException, ValueError) as problem:
        raise ValueError(f"Its output cannot be written: {details(problem)}") from None
    if counts_again != counts or target.stat().st_size == 0:
        raise ValueError("Its output cannot be written: not all of it is in the file.")


def _counts(document: pymeshlab.MeshSet) -> tuple[int, int]:
    mesh = document.current_mesh()
    return mesh.vertex_number(), mesh.face_number()


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


def _pymeshlab(value: Value) -> Any:
    if isinstance(value, str) and value.endswith("%"):
        return pymeshlab.PercentageValue(float(value[:-1]))
    return value
