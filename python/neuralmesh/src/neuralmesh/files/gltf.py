# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of glTF and GLB, by trimesh, which loads them whole: all parts in their places."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import trimesh

from .cloud import Chunk
from .registry import UnreadableFile


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices of each part."""
    if path.suffix.lower() == ".gltf":
        _require_whole(path)
    scene = trimesh.load_scene(path, process=False)
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


def _require_whole(path: Path) -> None:
    """Refuse glTF that is cut short, or of whose files beside it one is."""
    try:
        content = json.loads(path.read_bytes())
    except ValueError:
        raise UnreadableFile(path, "it is cut short, or no glTF: its JSON is broken.") from None
    for buffer in content.get("buffers", ()):
        address = buffer.get("uri", "data:")
        beside = path.parent / unquote(address)
        if address.startswith("data:") or not beside.is_file():
            continue  # trimesh names a file that is missing
        if beside.stat().st_size < buffer["byteLength"]:
            raise UnreadableFile(path, f"the file '{beside}', which it needs, is cut short.")


def _colours(part: object, count: int) -> np.ndarray | None:
    colours = getattr(part, "colors", None)  # of a point cloud
    visual = getattr(part, "visual", None)
    if visual is not None and getattr(visual, "kind", None) == "vertex":
        colours = visual.vertex_colors
    if colours is None or np.shape(colours)[:1] != (count,):
        return None
    return np.asarray(colours, dtype=np.uint8)[:, :3]
