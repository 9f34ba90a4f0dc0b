# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes meshes. PLY, NPZ, OBJ and OFF keep every digit; STL and GLB hold single precision."""

from __future__ import annotations

import io
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from .._result import Mesh
from .registry import UnreadableFile


def write(path: str | os.PathLike[str], mesh: Mesh) -> str:
    """Write a mesh in the format of the file's suffix: PLY, OBJ, STL, OFF, NPZ or GLB.

    The file appears when it is complete. Returns a remark: a sentence where the format cannot hold
    the coordinates exactly enough, empty otherwise. Raises ValueError for another suffix, OSError.
    """
    target = Path(path)
    writer = WRITTEN.get(target.suffix.lower())
    if writer is None:
        raise UnreadableFile(
            target, f"'{target.suffix}' cannot be written: give {', '.join(WRITTEN)}."
        )
    data = writer(mesh)
    temporary = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        temporary.write_bytes(data)
        temporary.replace(target)
    finally:
        temporary.unlink(missing_ok=True)
    return _rounding(target, mesh)


def _rounding(target: Path, mesh: Mesh) -> str:
    if target.suffix.lower() not in SINGLE_PRECISION:
        return ""
    lost = np.abs(mesh.vertices - mesh.vertices.astype(np.float32)).max(initial=0)
    edges = mesh.vertices[mesh.faces[:, 0]] - mesh.vertices[mesh.faces[:, 1]]
    if lost < 1e-3 * np.linalg.norm(edges, axis=1).mean():
        return ""
    kind = target.suffix[1:].upper()
    return f"{kind} holds single precision: coordinates are off by up to {lost:.2g}. PLY is exact."


def _ply(mesh: Mesh) -> bytes:
    fields = [("x", "<f8", "double"), ("y", "<f8", "double"), ("z", "<f8", "double")]
    if mesh.colours is not None:
        fields += [(name, "u1", "uchar") for name in ("red", "green", "blue", "alpha")]
    if mesh.quality is not None:
        fields.append(("quality", "<f8", "double"))
    vertices = np.empty(len(mesh.vertices), [(name, kind) for name, kind, _ in fields])
    for axis, name in enumerate("xyz"):
        vertices[name] = mesh.vertices[:, axis]
    if mesh.colours is not None:
        for channel, name in enumerate(("red", "green", "blue", "alpha")):
            vertices[name] = mesh.colours[:, channel]
    if mesh.quality is not None:
        vertices["quality"] = mesh.quality
    faces = np.empty(len(mesh.faces), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, mesh.faces
    header = [
        "ply",
        "format binary_little_endian 1.0",
        f"element vertex {len(vertices)}",
        *(f"property {kind} {name}" for name, _, kind in fields),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header\n",
    ]
    return "\n".join(header).encode("ascii") + vertices.tobytes() + faces.tobytes()


def _obj(mesh: Mesh) -> bytes:
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    if mesh.colours is not None:
        shares = (mesh.colours[:, :3] / 255).tolist()
        rows = [
            f"{row} {r:.4f} {g:.4f} {b:.4f}" for row, (r, g, b) in zip(rows, shares, strict=True)
        ]
    rows += [f"f {a} {b} {c}" for a, b, c in (mesh.faces + 1).tolist()]
    return ("\n".join(rows) + "\n").encode("ascii")


def _off(mesh: Mesh) -> bytes:
    rows = ["OFF", f"{len(mesh.vertices)} {len(mesh.faces)} 0"]
    rows += [f"{x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    rows += [f"3 {a} {b} {c}" for a, b, c in mesh.faces.tolist()]
    return ("\n".join(rows) + "\n").encode("ascii")


def _npz(mesh: Mesh) -> bytes:
    arrays: dict[str, Any] = {"vertices": mesh.vertices, "faces": mesh.faces}
    if mesh.colours is not None:
        arrays["colours"] = mesh.colours
    if mesh.quality is not None:
        arrays["quality"] = mesh.quality
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **arrays)
    return buffer.getvalue()


def _by_trimesh(kind: str) -> Callable[[Mesh], bytes]:
    def made(mesh: Mesh) -> bytes:
        import trimesh

        shown = trimesh.Trimesh(
            mesh.vertices, mesh.faces, vertex_colors=mesh.colours, process=False
        )
        data: Any = shown.export(file_type=kind)
        return bytes(data)

    return made


WRITTEN: dict[str, Callable[[Mesh], bytes]] = {
    ".ply": _ply,
    ".obj": _obj,
    ".off": _off,
    ".npz": _npz,
    ".stl": _by_trimesh("stl"),
    ".glb": _by_trimesh("glb"),
}
SINGLE_PRECISION = (".stl", ".glb")
