# SPDX-License-Identifier: GPL-3.0-or-later
"""A path is sampled in place where the core can, by the file's header, and read where not."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import neuralmesh
import numpy as np
import pytest
from neuralmesh import files
from plyfile import PlyData, PlyElement
from point_files import Points, las, ply, ply_text


def vertices(points: Points, kind: str) -> PlyElement:
    rows = np.empty(len(points), [(axis, kind) for axis in "xyz"])
    for axis, column in zip("xyz", points.T, strict=True):
        rows[axis] = column
    return PlyElement.describe(rows, "vertex")


def faces(count: int) -> PlyElement:
    rows = np.empty(count, [("vertex_indices", "O")])
    rows["vertex_indices"] = [np.array([0, 1, 2], "i4")] * count
    return PlyElement.describe(rows, "face", val_types={"vertex_indices": "i4"})


def whole_ply(path: Path, points: Points) -> None:
    PlyData([vertices(np.rint(points * 1000), "i4")]).write(str(path))


def faces_first_ply(path: Path, points: Points) -> None:
    PlyData([faces(5), vertices(points, "f8")]).write(str(path))


def commented_ply(path: Path, points: Points) -> None:
    ply_text(path, points, np.zeros((len(points), 3), np.uint8))
    comments = b"".join(b"comment %d of many\n" % number for number in range(30))
    path.write_bytes(path.read_bytes().replace(b"ply\n", b"ply\n" + comments, 1))


def laz(path: Path, points: Points) -> None:
    las(path.with_suffix(".laz"), points, np.zeros((len(points), 3), np.uint8))
    path.with_suffix(".laz").rename(path)


@pytest.mark.parametrize(
    ("name", "write"),
    [
        ("six.npy", lambda path, points: np.save(path, np.hstack([points, points]))),
        ("whole.npy", lambda path, points: np.save(path, np.rint(points * 1000).astype("i4"))),
        ("half.npy", lambda path, points: np.save(path, points.astype("f2"))),
        ("columns.npy", lambda path, points: np.save(path, np.asfortranarray(points))),
        ("whole.ply", whole_ply),
        ("faces_first.ply", faces_first_ply),
        ("comments.ply", commented_ply),
        ("compressed.las", laz),
    ],
)
def test_what_the_core_cannot_map_is_read(
    name: str, write: Callable[[Path, Points], None], ball: Points, tmp_path: Path
) -> None:
    path = tmp_path / name
    write(path, ball)
    assert not files.describe(path).in_place
    made = neuralmesh.reconstruct(path, 100)
    expected = neuralmesh.reconstruct(neuralmesh.read(path), 100)
    assert np.array_equal(made.vertices, expected.vertices)


@pytest.mark.parametrize(
    ("name", "write"),
    [
        ("double.npy", np.save),
        ("single.npy", lambda path, points: np.save(path, points.astype(">f4"))),
        ("a.ply", lambda path, points: ply(path, points, np.zeros((len(points), 3), np.uint8))),
        ("a.las", lambda path, points: las(path, points, np.zeros((len(points), 3), np.uint8))),
    ],
)
def test_what_the_core_maps_stays_on_the_disk(
    name: str,
    write: Callable[[Path, Points], None],
    ball: Points,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    path = tmp_path / name
    write(path, ball)
    assert files.describe(path).in_place
    monkeypatch.setattr(files, "read", None)
    assert len(neuralmesh.reconstruct(path, 100).vertices) == 100


def test_what_to_do_with_text_is_said_once(ball: Points, tmp_path: Path) -> None:
    ply_text(tmp_path / "text.ply", ball, np.zeros((len(ball), 3), np.uint8))
    (tmp_path / "text.ply").rename(tmp_path / "text.npy")
    with pytest.raises(ValueError, match=r"in place\. Save it as binary PLY\.$"):
        neuralmesh.reconstruct(tmp_path / "text.npy", 100)


@pytest.mark.parametrize("order", ["<", ">", ""])
def test_of_a_mesh_its_vertices_are_read_and_not_its_faces(order: str, tmp_path: Path) -> None:
    points = np.random.default_rng(0).random((100, 3))
    path = tmp_path / "mesh.ply"
    parts = [vertices(points, "f8"), faces(20_000)]
    PlyData(parts, text=not order, byte_order=order or "=").write(str(path))
    assert np.array_equal(neuralmesh.read(path).points, points)
    content = path.read_bytes()
    path.write_bytes(content[: -(len(content) // 2)])  # half of its faces are not there
    assert np.array_equal(neuralmesh.read(path).points, points)


def test_a_mesh_is_read_as_fast_as_its_vertices(tmp_path: Path) -> None:
    path = tmp_path / "mesh.ply"
    PlyData([vertices(np.ones((10, 3)), "f4")]).write(str(path))
    record = np.dtype([("n", "u1"), ("v", "<i4", 3)])
    rows = np.zeros(1_000_000, record)
    rows["n"] = 3
    more = b"element face 1000000\nproperty list uchar int vertex_indices\nend_header\n"
    content = path.read_bytes().replace(b"end_header\n", more, 1)
    path.write_bytes(content + rows.tobytes())
    begin = time.process_time()
    assert len(neuralmesh.read(path).points) == 10
    # A million lists took plyfile 3 s; 13 MB that are not read take a millisecond.
    assert time.process_time() - begin < 0.5


def test_vertices_that_are_cut_short_are_refused_with_both_counts(tmp_path: Path) -> None:
    PlyData([vertices(np.ones((10, 3)), "f4")]).write(str(tmp_path / "a.ply"))
    (tmp_path / "a.ply").write_bytes((tmp_path / "a.ply").read_bytes()[:-12])
    with pytest.raises(ValueError, match="its header promises 10 vertices, but it holds 9"):
        neuralmesh.read(tmp_path / "a.ply")
