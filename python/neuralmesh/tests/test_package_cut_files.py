# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are cut short or damaged: refused in a sentence of ours, or whole; never a part."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import neuralmesh
import numpy as np
import pytest
import trimesh
from point_files import WRITERS, Colours, Points, e57, gltf, npz

SHARES = (0.0, 0.001, 0.1, 0.5, 0.9, 0.99, 1.0)  # of the bytes that stay; of 1.0 all but one

# Lists without a count end where they end: what is there is read.
LISTS = {"plain.xyz", "header.csv", "semicolons.csv", "comments.txt", "mesh.obj"}
# What is cut off may be the end of the last number, or nothing but what stands behind the points.
MAY_LOSE_NO_POINT = {
    *("text.ply", "ascii.pcd", "leica.pts", "mesh.off", "text.stl", "octree.copc.laz")
}
OURS = (
    "it is cut short",
    "it is broken",
    "it is no ",
    "it holds no points.",
    "it has no header of a PCD file.",
    "its first line is none of points: ",
    "its header names no coordinates, ",
    "its lines have fewer than three numbers, ",
)


def stl(path: Path, points: Points, colours: Colours) -> None:
    """300 vertices of a strip."""
    faces = np.arange(298)[:, None] + np.arange(3)
    kind = "stl" if path.name.startswith("binary") else "stl_ascii"
    trimesh.Trimesh(points, faces, process=False).export(path, file_type=kind)


FORMATS = [(name, writer) for name, writer, *_ in WRITERS] + [
    ("binary.stl", stl),
    ("text.stl", stl),
]


def points_or_reason(path: Path) -> Points | str:
    """What a file holds, or the sentence behind its path."""
    try:
        return neuralmesh.read(path).points
    except ValueError as error:
        start = f"'{path}': "
        return str(error).removeprefix(start) if str(error).startswith(start) else "no path"


@pytest.fixture(scope="module")
def cloud() -> tuple[Points, Colours]:
    random = np.random.default_rng(3)
    points = np.round(random.random((300, 3)), 6)
    return points, random.integers(0, 256, (300, 3), dtype=np.uint8)


@pytest.mark.parametrize("share", SHARES)
@pytest.mark.parametrize(("name", "writer"), FORMATS, ids=[name for name, _ in FORMATS])
def test_a_cut_file_is_refused_in_a_sentence_unless_all_points_are_there(
    name: str,
    writer: Callable[[Path, Points, Colours], None],
    share: float,
    cloud: tuple[Points, Colours],
    tmp_path: Path,
) -> None:
    path = tmp_path / name
    writer(path, *cloud)
    content = path.read_bytes()
    path.write_bytes(content[: min(int(share * len(content)), len(content) - 1)])
    found = points_or_reason(path)
    if isinstance(found, str):
        assert found.startswith(OURS)
        assert found.endswith(".")
    else:
        assert name in LISTS | MAY_LOSE_NO_POINT
        assert len(found) == 300 or name in LISTS
        assert found[:-1] == pytest.approx(cloud[0][: len(found) - 1], abs=1e-6)


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("scan.e57", r"its header promises [\d,]+ bytes, but it holds [\d,]+"),
        ("mesh.glb", r"its header promises [\d,]+ bytes, but it holds [\d,]+"),
        ("array.npy", "its header promises 7,328 bytes, but it holds 3,664"),
        ("binary.pcd", "its header promises 300 points, but it holds 1.."),
        ("ascii.pcd", "its header promises 300 points, but it holds 1..|or its last line is none"),
        ("mesh.off", "its header promises 300 vertices, but it holds 1..|or its last line is none"),
        ("binary.stl", "its header promises 298 triangles, but it holds 148"),
    ],
)
def test_of_half_a_file_both_lengths_are_told(
    name: str, sentence: str, cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    dict(FORMATS)[name](tmp_path / name, *cloud)
    content = (tmp_path / name).read_bytes()
    (tmp_path / name).write_bytes(content[: len(content) // 2])
    with pytest.raises(ValueError, match=f"it is cut short(:|,) ({sentence})"):
        neuralmesh.read(tmp_path / name)


@pytest.mark.parametrize("share", [0.3, 0.6, 0.8])
@pytest.mark.parametrize(
    "name", ["scan.e57", "scan.laz", "arrays.npz", "mesh.glb", "compressed.pcd", "mesh.gltf"]
)
def test_what_a_library_says_of_damage_is_never_shown(
    name: str, share: float, cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    path = tmp_path / name
    dict(FORMATS)[name](path, *cloud)
    content = bytearray(path.read_bytes())
    begin = int(share * len(content))
    content[begin : begin + 64] = b"\xa5" * 64
    path.write_bytes(content)
    found = points_or_reason(path)
    if isinstance(found, str):
        assert found.startswith(OURS)
    else:  # nothing but coordinates and colours, which are any, or what no reader looks at
        assert len(found) == 300


@pytest.mark.parametrize(
    ("write", "damaged_byte", "sentence"),
    [(e57, 200, "E57"), (npz, 3000, "NumPy's")],  # of npz, a coordinate
)
def test_damage_is_told_by_the_checksums_of_a_format(
    write: Callable[[Path, Points, Colours], None],
    damaged_byte: int,
    sentence: str,
    cloud: tuple[Points, Colours],
    tmp_path: Path,
) -> None:
    path = tmp_path / f"a.{write.__name__}"
    write(path, *cloud)
    content = bytearray(path.read_bytes())
    content[damaged_byte] ^= 1
    path.write_bytes(content)
    with pytest.raises(ValueError, match=rf"': it is broken, or its content is not {sentence}"):
        neuralmesh.read(path)


def test_of_a_gltf_a_file_beside_it_that_is_cut_is_named(
    cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    gltf(tmp_path / "a.gltf", *cloud)
    beside = next(tmp_path.glob("*.bin"))
    beside.write_bytes(beside.read_bytes()[:-1])
    with pytest.raises(ValueError, match=r"the file '.*\.bin', which it needs, is cut short"):
        neuralmesh.read(tmp_path / "a.gltf")
