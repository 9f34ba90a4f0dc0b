# SPDX-License-Identifier: GPL-3.0-or-later
"""The vertices of STL, OFF, glTF and GLB, by trimesh: all parts, each in its place."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import trimesh

from .cloud import Chunk


def chunks(path: Path) -> Iterator[Chunk]:
    """Yield the vertices of each part. Those of STL, which has one for each corner, are merged."""
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


def _colours(part: object, count: int) -> np.ndarray | None:
    colours = getattr(part, "colors", None)  # of a point cloud
    visual = getattr(part, "visual", None)
    if visual is not None and getattr(visual, "kind", None) == "vertex":
        colours = visual.vertex_colors
    if colours is None or np.shape(colours)[:1] != (count,):
        return None
    return np.asarray(colours, dtype=np.uint8)[:, :3]
