# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes points (n, 3) and colours (n, 3) of 8 bits in every format that is read."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import laspy
import numpy as np
import pye57
import trimesh
from copc_file import copc
from numpy.typing import NDArray
from plyfile import PlyData, PlyElement

Points = NDArray[np.float64]
Colours = NDArray[np.uint8]


def ply(path: Path, points: Points, colours: Colours, text: bool = False) -> None:
    names = [("x", "f8"), ("y", "f8"), ("z", "f8"), ("red", "u1"), ("green", "u1"), ("blue", "u1")]
    rows = np.empty(len(points), names)
    for column, (name, _) in enumerate(names):
        rows[name] = points[:, column] if column < 3 else colours[:, column - 3]
    PlyData([PlyElement.describe(rows, "vertex")], text=text).write(str(path))


def ply_text(path: Path, points: Points, colours: Colours) -> None:
    ply(path, points, colours, text=True)


def las(path: Path, points: Points, colours: Colours) -> None:
    file = laspy.create(point_format=7, file_version="1.4")
    file.header.scales, file.header.offsets = [1e-6] * 3, [0.0] * 3
    file.x, file.y, file.z = points.T
    file.red, file.green, file.blue = colours.T.astype(np.uint16) * 256
    file.write(path)


def e57(path: Path, points: Points, colours: Colours) -> None:
    with pye57.E57(str(path), mode="w") as file:
        half = len(points) // 2
        for part in (slice(None, half), slice(half, None)):
            data = {f"cartesian{axis}": points[part, k] for k, axis in enumerate("XYZ")}
            names = ("colorRed", "colorGreen", "colorBlue")
            data |= {name: colours[part, k] for k, name in enumerate(names)}
            file.write_scan_raw(data)


def pcd_head(points: Points, kind: str, size: int = 8) -> bytes:
    return (
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb\n"
        f"SIZE {size} {size} {size} 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH {len(points)}\nHEIGHT 1\n"
        f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(points)}\nDATA {kind}\n"
    ).encode()


def packed_colours(colours: Colours) -> NDArray[np.uint32]:
    wide = colours.astype(np.uint32)
    return wide[:, 0] << 16 | wide[:, 1] << 8 | wide[:, 2]


def pcd_ascii(path: Path, points: Points, colours: Colours) -> None:
    lines = [
        f"{x!r} {y!r} {z!r} {c}"
        for (x, y, z), c in zip(points.tolist(), packed_colours(colours), strict=True)
    ]
    path.write_bytes(pcd_head(points, "ascii") + "\n".join(lines).encode() + b"\n")


def pcd_binary(path: Path, points: Points, colours: Colours) -> None:
    rows = np.empty(len(points), [("xyz", "<f8", 3), ("rgb", "<u4")])
    rows["xyz"], rows["rgb"] = points, packed_colours(colours)
    path.write_bytes(pcd_head(points, "binary") + rows.tobytes())


def lzf(data: bytes) -> bytes:
    """Literal bytes, and a repetition of eight where the eight before come again."""
    out, k = bytearray(), 0
    while k < len(data):
        if k >= 8 and data[k : k + 8] == data[k - 8 : k] and k + 8 <= len(data):
            out += bytes([6 << 5, 7])  # eight bytes from eight bytes back
            k += 8
        else:
            part = data[k : k + 8]
            out += bytes([len(part) - 1]) + part
            k += 8
    return bytes(out)


def pcd_compressed(path: Path, points: Points, colours: Colours) -> None:
    block = points.T.tobytes() + packed_colours(colours).tobytes()
    packed = lzf(block)
    sizes = struct.pack("<II", len(packed), len(block))
    path.write_bytes(pcd_head(points, "binary_compressed") + sizes + packed)


def table(path: Path, points: Points, extra: NDArray, separator: str = " ", head: str = "") -> None:
    rows = [
        separator.join([*map(repr, p), *(f"{value:g}" for value in e)])
        for p, e in zip(points.tolist(), extra.tolist(), strict=True)
    ]
    path.write_text(head + "\n".join(rows) + "\n", "utf-8")


def xyz(path: Path, points: Points, colours: Colours) -> None:
    table(path, points, colours)


def csv(path: Path, points: Points, colours: Colours) -> None:
    table(path, points, colours, ",", "x,y,z,red,green,blue\n")


def csv_other_order(path: Path, points: Points, colours: Colours) -> None:
    rows = np.column_stack([np.arange(len(points)), colours])
    lines = ['"id";"R";"G";"B";"Z";"Y";"X"']
    for row, (x, y, z) in zip(rows.tolist(), points.tolist(), strict=True):
        lines.append(";".join([*map(str, row), repr(z), repr(y), repr(x)]).replace(".", ","))
    path.write_text("\n".join(lines), "utf-8")


def commented(path: Path, points: Points, colours: Colours) -> None:
    table(path, points, colours, "\t", "\ufeff# made by a scanner\n// X Y Z R G B\n\n")


def pts(path: Path, points: Points, colours: Colours) -> None:
    """Two scans: count, then x y z intensity r g b."""
    extra = np.column_stack([np.full(len(points), -1200), colours])
    half = len(points) // 2
    parts = []
    for part in (slice(None, half), slice(half, None)):
        table(path, points[part], extra[part], head=f"{len(points[part])}\n")
        parts.append(path.read_text("utf-8"))
    path.write_text("".join(parts), "utf-8")


def npz(path: Path, points: Points, colours: Colours) -> None:
    np.savez(path, points=points, colours=colours)


def obj(path: Path, points: Points, colours: Colours) -> None:
    lines = ["# vertices", "o cloud"]
    for p, c in zip(points.tolist(), (colours / 255).tolist(), strict=True):
        lines.append("v " + " ".join(map(repr, [*p, *c])))
    path.write_text("\n".join([*lines, "vn 0 0 1", "f 1//1 2//1 3//1"]), "utf-8")


def glb(path: Path, points: Points, colours: Colours) -> None:
    """In a scene that moves it by 5 along x."""
    scene = trimesh.Scene()
    cloud = trimesh.PointCloud(points - [5, 0, 0], colors=colours)
    scene.add_geometry(cloud, transform=trimesh.transformations.translation_matrix([5, 0, 0]))
    path.write_bytes(scene.export(file_type="glb"))


def gltf(path: Path, points: Points, colours: Colours) -> None:
    """With its numbers in a file beside it."""
    scene = trimesh.Scene(trimesh.PointCloud(points, colors=colours))
    for name, data in scene.export(file_type="gltf").items():
        (path if name.endswith(".gltf") else path.with_name(name)).write_bytes(data)


def off(path: Path, points: Points, colours: Colours) -> None:
    lines = ["OFF", f"{len(points)} 0 0", *(" ".join(map(repr, p)) for p in points.tolist())]
    path.write_text("\n".join(lines) + "\n", "utf-8")


WRITERS: list[tuple[str, Callable[[Path, Points, Colours], None], float, bool]] = [
    # Name, what writes it, how exact it is, whether it has colours.
    ("binary.ply", ply, 0, True),
    ("text.ply", ply_text, 1e-7, True),
    ("scan.las", las, 1e-9, True),
    ("scan.laz", las, 1e-9, True),
    ("octree.copc.laz", copc, 1e-9, True),
    ("scan.e57", e57, 1e-6, True),
    ("ascii.pcd", pcd_ascii, 0, True),
    ("binary.pcd", pcd_binary, 0, True),
    ("compressed.pcd", pcd_compressed, 0, True),
    ("plain.xyz", xyz, 0, True),
    ("header.csv", csv, 0, True),
    ("semicolons.csv", csv_other_order, 0, True),
    ("comments.txt", commented, 0, True),
    ("leica.pts", pts, 0, True),
    ("array.npy", lambda path, points, _: np.save(path, points), 0, False),
    ("arrays.npz", npz, 0, True),
    ("mesh.obj", obj, 0, True),
    ("mesh.glb", glb, 1e-6, True),
    ("mesh.gltf", gltf, 1e-6, True),
    ("mesh.off", off, 1e-9, False),
]
