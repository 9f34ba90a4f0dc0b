# SPDX-License-Identifier: GPL-3.0-or-later
"""PyMeshLab's documents and layers, to and from arrays, and its words as sentences."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pymeshlab

from neuralmesh_tools.files import is_foreign_byte, shown
from neuralmesh_tools.geometry import Faces, Points

# Of a file of which no points were read: so many bytes are looked at, so many letters shown.
BEGINNING = 65536
LINE_SHOWN = 60
# In the headers of PLY and of OFF.
NO_VERTICES = re.compile(rb"^element\s+vertex\s+0\s*$|\A\s*C?N?OFF\s+0\s", re.MULTILINE)


@cache
@cache
def load_plugin(path: Path) -> None:
    """Load a plugin into PyMeshLab, once a process. Raises what PyMeshLab raises."""
    pymeshlab.load_plugin(str(path))


def document_of(
    points: Points,
    faces: Faces | None = None,
    normals: Points | None = None,
    label: str = "",
    *,
    verbose: bool = False,
) -> pymeshlab.MeshSet:
    """Return a document with one layer: vertices (n, 3), faces (m, 3), vertex normals (n, 3).

    verbose: whether the document prints what it and its filters have to say.
    """
    given: dict[str, Any] = {"vertex_matrix": points}
    if faces is not None:
        given["face_matrix"] = faces
    if normals is not None:
        given["v_normals_matrix"] = normals
    document = pymeshlab.MeshSet(verbose=verbose)
    document.add_mesh(pymeshlab.Mesh(**given), label)
    return document


def read_document(path: Path, *, verbose: bool = False) -> pymeshlab.MeshSet:
    """Read a file into a document of its own; raises ValueError with a sentence if it cannot be.

    verbose: whether the document prints what it and its filters have to say.
    """
    document = pymeshlab.MeshSet(verbose=verbose)
    try:
        with _as_text(path) as readable:
            document.load_new_mesh(str(readable))
    except pymeshlab.PyMeshLabException as problem:
        raise ValueError(f"It cannot be read: {details(problem)}") from None
    return document


def why_no_points(path: Path) -> str:
    """Say of a file of which PyMeshLab has read no points whether it holds none, or others.

    PyMeshLab passes over lines that it cannot read, and says nothing of it.
    """
    with path.open("rb") as stream:
        beginning = stream.read(BEGINNING)
    if NO_VERTICES.search(beginning):
        return "It holds no points."
    lines = (line.strip() for line in beginning.decode("utf-8", "replace").splitlines())
    told = [line for line in lines if line and not line.startswith(("#", "//"))]
    if not told:
        return "It holds no points."
    if b"\0" in beginning:
        return f"No points of it can be read, though it is not empty: is it a {path.suffix} file?"
    return f"No points of it can be read: its first line is '{shown(told[0][:LINE_SHOWN])}'."


@contextmanager
def _as_text(path: Path) -> Iterator[Path]:
    """A path by which PyMeshLab finds a file: through a link where its name is no UTF-8.

    Nor may it begin with a colon: alone, as PyMeshLab hands it on, such a name is one of Qt's own.
    """
    is_plain = not any(is_foreign_byte(character) for character in str(path))
    if is_plain and not path.name.startswith(":"):
        yield path
        return
    with tempfile.TemporaryDirectory() as folder:
        ending = path.suffix if path.suffix.isascii() else ""
        link = Path(folder) / f"input{ending}"
        link.symlink_to(path.absolute())
        yield link


def arrays_of(document: pymeshlab.MeshSet, layer: int | None = None) -> tuple[Points, Faces]:
    """Return copies of a layer's vertices (n, 3) and faces (m, 3), which outlive the document.

    layer: its id; left out, the current one. A layer itself is gone as soon as its document is.
    """
    mesh = document.current_mesh() if layer is None else document.mesh(layer)
    return mesh.vertex_matrix().copy(), mesh.face_matrix().astype(np.int32, order="C")


def details(problem: Exception) -> str:
    """The part of PyMeshLab's words that says what is wrong, as a sentence."""
    words = " ".join(str(problem).split("etails:")[-1].split()) or type(problem).__name__
    return words if words.endswith(".") else words + "."


def figures_of(returned: dict[str, Any] | None) -> dict[str, Any]:
    """What a filter returned, with lists for arrays: it can be written as JSON."""
    arrays = np.ndarray | np.generic
    return {
        name: value.tolist() if isinstance(value, arrays) else value
        for name, value in (returned or {}).items()
    }
