# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of STL, OFF, glTF and GLB, by trimesh: all parts, each in its place."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import trimesh

from .cloud import Chunk
from .registry import UnreadableFile

STL_HEADER = 84  # bytes: 80 of any kind, and the number of triangles
STL_TRIANGLE = 50  # bytes


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices of each part. Those of STL, which has one for each corner, are merged."""
    if path.suffix.lower() == ".stl":
        _require_whole_stl(path)
    scene = trimesh.load_scene(path, process=path.suffix.lower() == ".stl")
    names = list(scene.graph.nodes_geometry)
    for number, node in enumerate(names):
        transform, name = scene.graph[node]
        part = scene.geometry[name]
        if not len(getattr(part, "vertices", ())):
            continue
        points = trimesh.transform_points(part.vertices, transform)
        yield Chunk(
            np.ascontiguousarray(points, dtype=np.float64),
            _colours(part, len(points)),
            (number + 1) / len(names),
        )


def _require_whole_stl(path: Path) -> None:
    """Refuse binary STL that is cut short, which would be taken for text."""
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(STL_HEADER)
        is_text = head.lstrip().startswith(b"solid") and b"\0" not in head + file.read(4096)
    if is_text or size == 0:
        return
    if len(head) < STL_HEADER:
        raise UnreadableFile(path, "it is cut short, or no STL file.")
    promised = int.from_bytes(head[-4:], "little")
    held = (size - STL_HEADER) // STL_TRIANGLE
    if held < promised:
        raise UnreadableFile(
            path, f"it is cut short: of {promised:,} triangles of its header, it holds {held:,}."
        )


def _colours(part: object, count: int) -> np.ndarray | None:
    colours = getattr(part, "colors", None)  # of a point cloud
    visual = getattr(part, "visual", None)
    if visual is not None and getattr(visual, "kind", None) == "vertex":
        colours = visual.vertex_colors
    if colours is None or np.shape(colours)[:1] != (count,):
        return None
    return np.asarray(colours, dtype=np.uint8)[:, :3]
