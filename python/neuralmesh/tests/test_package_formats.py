# SPDX-License-Identifier: GPL-3.0-or-later
"""Files: every format gives the points that were put into it; what is broken is named."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import laspy
import neuralmesh
import numpy as np
import pytest
import trimesh
from neuralmesh import files
from neuralmesh.files.cloud import Chunk, Reservoir
from point_files import WRITERS, Colours, Points, copc, gltf, las, pcd_binary, ply_text, table, xyz


@pytest.fixture(scope="module")
def cloud() -> tuple[Points, Colours]:
    """300 points, the last 50 of which repeat some."""
    random = np.random.default_rng(3)
    points = np.round(random.random((300, 3)), 6) + np.array([4, 0, -2])
    points[250:] = points[0]
    colours = random.integers(0, 256, (300, 3), dtype=np.uint8)
    return points, colours


@pytest.mark.parametrize(
    ("name", "writer", "tolerance", "has_colours"), WRITERS, ids=[row[0] for row in WRITERS]
)
def test_a_file_gives_the_points_in_order(
    name: str,
    writer: Callable[[Path, Points, Colours], None],
    tolerance: float,
    has_colours: bool,
    cloud: tuple[Points, Colours],
    tmp_path: Path,
) -> None:
    writer(tmp_path / name, *cloud)
    found = neuralmesh.read(tmp_path / name)
    assert found.points.shape == (300, 3)
    assert found.total == 300
    assert np.abs(found.points - cloud[0]).max() <= tolerance
    assert (found.colours is not None) == has_colours
    if found.colours is not None:
        assert np.array_equal(found.colours, cloud[1])


def test_every_suffix_is_tested() -> None:
    tested = {Path(name).suffix for name, *_ in WRITERS} | {".stl", ".xyzrgb", ".asc"}
    assert tested == {suffix for known in files.FORMATS for suffix in known.suffixes}


def test_the_copc_that_is_tested_is_one(cloud: tuple[Points, Colours], tmp_path: Path) -> None:
    copc(tmp_path / "a.copc.laz", *cloud)
    with laspy.CopcReader.open(tmp_path / "a.copc.laz") as file:
        found, coarse = file.query(), file.query(level=0)
    places = np.column_stack([found.x, found.y, found.z])
    assert np.sort(places, axis=0) == pytest.approx(np.sort(cloud[0], axis=0))
    assert len(coarse) == 30


def test_corners_of_an_stl_are_merged(tmp_path: Path) -> None:
    trimesh.creation.icosphere(subdivisions=2).export(tmp_path / "ball.stl")
    assert neuralmesh.read(tmp_path / "ball.stl").points.shape == (162, 3)


def test_normals_are_not_taken_for_colours(tmp_path: Path) -> None:
    points = np.random.default_rng(0).normal(size=(50, 3))
    table(tmp_path / "normals.xyz", points, points)
    assert neuralmesh.read(tmp_path / "normals.xyz").colours is None


@pytest.mark.parametrize(
    "header",
    ["X Y Z", "//X_coord Y_coord Z_coord", '"Points:0","Points:1","Points:2"', "# a note\n3", ""],
)
def test_headers_that_programs_write(header: str, tmp_path: Path) -> None:
    separator = "," if "," in header else " "
    lines = [separator.join(row) for row in (("1", "2", "3"), ("4", "5", "6"), ("7", "8", "9"))]
    (tmp_path / "a.txt").write_text("\r\n".join([header, *lines, ""]), "utf-8")
    assert neuralmesh.read(tmp_path / "a.txt").points.tolist() == [[1, 2, 3], [4, 5, 6], [7, 8, 9]]


def test_a_path_of_any_format_is_reconstructed_with_its_colours(
    ball: Points, tmp_path: Path
) -> None:
    colours = np.full((5000, 3), [200, 100, 0], np.uint8)
    las(tmp_path / "ball.laz", ball, colours)
    made = neuralmesh.reconstruct(tmp_path / "ball.laz", 200)
    assert np.array_equal(made.colours, np.tile([200, 100, 0, 255], (200, 1)).astype(np.uint8))
    read = neuralmesh.read(tmp_path / "ball.laz")
    assert np.array_equal(neuralmesh.reconstruct(read, 200).vertices, made.vertices)
    ply_text(tmp_path / "ball.ply", ball, colours)
    assert neuralmesh.reconstruct(tmp_path / "ball.ply", 200).colours is not None


def test_points_without_a_return_are_left_out_of_a_pcd(
    cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    points = cloud[0].copy()
    points[::3] = np.nan
    pcd_binary(tmp_path / "scan.pcd", points, cloud[1])
    assert len(neuralmesh.read(tmp_path / "scan.pcd").points) == 200


@pytest.mark.parametrize("look", [neuralmesh.read, files.describe])
def test_a_file_without_a_finite_point_says_so(
    look: Callable[[Path], object], tmp_path: Path
) -> None:
    pcd_binary(tmp_path / "a.pcd", np.full((3000, 3), np.nan), np.zeros((3000, 3), np.uint8))
    with pytest.raises(ValueError, match="none of its 3,000 points is finite"):
        look(tmp_path / "a.pcd")


def test_fields_of_a_pcd_may_be_called_columns(
    cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    pcd_binary(tmp_path / "a.pcd", *cloud)
    content = (tmp_path / "a.pcd").read_bytes()
    (tmp_path / "a.pcd").write_bytes(content.replace(b"FIELDS", b"COLUMNS"))
    assert np.array_equal(neuralmesh.read(tmp_path / "a.pcd").points, cloud[0])


@pytest.mark.parametrize(
    ("name", "bytes_left", "sentence"),
    [
        # A point of format 7 takes 36 bytes.
        ("a.las", -36 * 3, "it is cut short: its header promises 300 points, but it holds 297."),
        ("a.las", -1, "it is cut short: its header promises 300 points, but it holds 299."),
        ("a.laz", -40, "it is cut short or broken: its header promises 300 points, of which 0 "),
    ],
)
def test_lidar_that_is_cut_short_is_refused_with_both_counts(
    name: str, bytes_left: int, sentence: str, cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    las(tmp_path / name, *cloud)
    (tmp_path / name).write_bytes((tmp_path / name).read_bytes()[:bytes_left])
    with pytest.raises(ValueError, match=sentence):
        neuralmesh.read(tmp_path / name)


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("a.docx", b"", r"'\.docx' is of no format that is read here: \.ply, "),
        ("a.xyz", b"", "it holds no points"),
        ("a.xyz", b"hello world\n", "its first line is none of points: 'hello world'"),
        ("a.xyz", b"1 2 3\n4 5 x\n", "this line is none of points: '4 5 x'"),
        ("a.xyz", b"1 2\n", "fewer than three numbers"),
        ("a.pts", b"[Expe\x80\xff\x00", "it is not text|none of points"),
        ("a.pcd", b"hello\n" * 70, "it has no header of a PCD file"),
        ("a.pcd", b"VERSION 0.7\nSIZE 4 4 4\nDATA ascii\n", r"its header has no line FIELDS\.$"),
        ("a.pcd", b"FIELDS x\nSIZE 4\nDATA ascii\n", r"its header has no line TYPE\.$"),
        ("a.pcd", b"FIELDS x y\nSIZE 4\nTYPE F F\nDATA ascii\n", "more fields in one line than"),
        ("a.pcd", b"FIELDS x\nSIZE 3\nTYPE F\nDATA ascii\n", "x is of the unknown type F 3"),
        ("a.pcd", b"FIELDS x\nSIZE 4\nTYPE F\nPOINTS a\nDATA ascii\n", "POINTS of other than wh"),
        (
            "a.stl",
            bytes(80) + b"\3\0\0\0" + bytes(120),
            "its header promises 3 triangles, but it holds 2",
        ),
        ("a.stl", b"solid\nvertex 1 2 3\nendsolid", "its last triangle has 1 corners"),
        ("a.stl", b"hello", "it is cut short, or no STL file"),
        ("a.ply", b"ply\nformat ascii 1.0\nend_header\n", "it has no vertices"),
        ("a.las", b"LASF" + bytes(400), "it is broken, or its content is not LAS, LAZ or COPC"),
        ("a.laz", b"hello", "it is no LAS or LAZ file"),
        ("a.e57", b"hello", r"it is no E57 file: it does not begin as one\.$"),
        ("a.npy", b"hello", "it is no NPY file"),
        ("a.glb", b"hello", "it is no GLB file"),
        ("a.glb", b"glTF" + bytes(8), "it is broken, or its content is not GLB or glTF"),
        ("a.off", b"hello", "its first line does not begin with OFF"),
        ("a.off", b"OFF BINARY\n", "it is binary OFF"),
        ("a.stl", bytes(80) + bytes(4) + bytes(50), "promises 0 triangles, but it holds 1"),
        ("a.obj", b"hello\n", "it holds no points"),
    ],
)
def test_a_broken_file_is_named_with_the_reason(
    name: str, content: bytes, sentence: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(ValueError, match=sentence) as caught:
        neuralmesh.read(tmp_path / name)
    assert str(caught.value).startswith(f"'{tmp_path / name}': ")


def test_a_file_that_another_one_needs_is_named_with_it(
    cloud: tuple[Points, Colours], tmp_path: Path
) -> None:
    gltf(tmp_path / "a.gltf", *cloud)
    for beside in tmp_path.glob("*.bin"):
        beside.unlink()
    with pytest.raises(
        ValueError, match=r"a\.gltf': it cannot be read: a file that it needs is missing: '.*\.bin'"
    ):
        neuralmesh.read(tmp_path / "a.gltf")


def test_an_array_of_another_shape_is_named(tmp_path: Path) -> None:
    np.save(tmp_path / "a.npy", np.zeros(5))
    with pytest.raises(ValueError, match=r"it holds float64 of the shape \(5,\), not N x 3"):
        neuralmesh.read(tmp_path / "a.npy")


@pytest.mark.parametrize("broken", [b"\x20\x05", b"\xff", b"\x1f" + bytes(32), b"\x00\x00" * 9])
def test_a_broken_packed_block_is_refused(broken: bytes) -> None:
    with pytest.raises(ValueError, match="The packed block"):
        neuralmesh._core.lzf_decompressed(broken, 20)


# ---------------------------------------------------------------------------- more than fits


def test_a_choice_is_uniform_without_repetition_and_in_order() -> None:
    reservoir = Reservoir(1000)
    for begin in range(0, 100_000, 700):
        numbers = np.arange(begin, min(begin + 700, 100_000), dtype=np.float64)
        reservoir.add(Chunk(np.repeat(numbers[:, None], 3, axis=1)))
    found = reservoir.cloud()
    chosen = found.points[:, 0]
    assert found.total == 100_000
    assert found.is_choice
    assert len(chosen) == 1000
    assert (np.diff(chosen) > 0).all()
    counts = np.histogram(chosen, 20, (0, 100_000))[0]
    # Of 19 degrees of freedom, one in a thousand is above 44.
    assert ((counts - 50) ** 2 / 50).sum() < 44


def test_a_cloud_that_fits_is_kept_whole(tmp_path: Path, cloud: tuple[Points, Colours]) -> None:
    xyz(tmp_path / "a.xyz", *cloud)
    assert np.array_equal(neuralmesh.read(tmp_path / "a.xyz", most_points=300).points, cloud[0])
    choice = neuralmesh.read(tmp_path / "a.xyz", most_points=100)
    assert len(choice.points) == 100
    assert choice.total == 300


@pytest.mark.parametrize("suffix", [".ply", ".obj", ".off", ".npz", ".stl", ".glb"])
def test_a_written_mesh_is_read_again(suffix: str, ball: Points, tmp_path: Path) -> None:
    colours = np.where(ball[:, :1] > 0, [255, 0, 0], [0, 0, 255])
    made = neuralmesh.reconstruct(ball, 100, colours=colours, quality=ball[:, 2])
    path = tmp_path / f"ball{suffix}"
    assert neuralmesh.write(path, made) == ""
    assert [file.name for file in tmp_path.iterdir()] == [path.name]
    found = neuralmesh.read(path)
    if suffix == ".stl":  # its corners are merged in an order of their own
        assert found.points.shape == (100, 3)
    else:
        exact = suffix != ".glb"
        assert np.abs(found.points - made.vertices).max() <= (0 if exact else 1e-6)
    shown = trimesh.load_mesh(path, process=False) if suffix != ".npz" else None
    if shown is not None:
        assert len(shown.faces) == 196


def test_loss_of_precision_is_told(ball: Points, tmp_path: Path) -> None:
    far = neuralmesh.reconstruct(ball + np.array([4e5, 5e6, 100]), 100)
    assert "STL holds single precision" in neuralmesh.write(tmp_path / "a.stl", far)
    assert neuralmesh.write(tmp_path / "a.ply", far) == ""
    assert np.array_equal(neuralmesh.read(tmp_path / "a.ply").points, far.vertices)
