# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are read in blocks, whatever their size: little memory, and Ctrl-C between them."""

from __future__ import annotations

import importlib
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import neuralmesh
import numpy as np
import pye57
import pytest
import trimesh
from neuralmesh.files import e57, stl
from neuralmesh.files.registry import format_of
from point_files import WRITERS, Colours, Points

WHOLE = {".glb", ".gltf"}  # and the block of compressed.pcd, as docs/python.md says
LIMITS = {"POINTS": 70, "LINES": 70, "TRIANGLES": 70}


@pytest.mark.parametrize(
    ("name", "writer"),
    [row[:2] for row in WRITERS if Path(row[0]).suffix not in WHOLE and row[0] != "compressed.pcd"],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_file_comes_in_blocks(
    name: str,
    writer: Callable[[Path, Points, Colours], None],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    random = np.random.default_rng(3)
    points, colours = random.random((300, 3)), random.integers(0, 256, (300, 3), dtype=np.uint8)
    writer(tmp_path / name, points, colours)
    known = format_of(tmp_path / name)
    for module in (known.module, "lines"):
        holder = importlib.import_module(f"neuralmesh.files.{module}")
        for limit in LIMITS.keys() & vars(holder).keys():
            monkeypatch.setattr(holder, limit, 70)
    blocks = list(known.chunks(tmp_path / name))
    assert max(len(block.points) for block in blocks) <= 70
    assert np.vstack([block.points for block in blocks]) == pytest.approx(points, abs=1e-6)
    shares = [block.done for block in blocks]
    assert shares == sorted(shares)
    assert shares[-1] == 1


def test_each_scan_of_an_e57_has_its_pose_and_lacks_its_invalid_points(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    random, path = np.random.default_rng(3), tmp_path / "a.e57"
    with pye57.E57(str(path), mode="w") as file:
        for turn in ([1.0, 0, 0, 0], [0.5, 0.5, 0.5, 0.5]):
            data = {f"cartesian{axis}": random.random(100) for axis in "XYZ"}
            data["cartesianInvalidState"] = np.arange(100) % 3
            shift = random.random(3) * 10
            file.write_scan_raw(data, rotation=np.array(turn), translation=shift)
    with pye57.E57(str(path)) as file:
        scans = [file.read_scan(n, ignore_missing_fields=True) for n in range(2)]
    monkeypatch.setattr(e57, "POINTS", 7)
    blocks = list(e57.chunks(path))
    expected = [np.column_stack([scan[f"cartesian{axis}"] for axis in "XYZ"]) for scan in scans]
    assert np.vstack([block.points for block in blocks]) == pytest.approx(np.vstack(expected))
    assert sum(block.left_out for block in blocks) == 132


def spherical_e57(path: Path, has_limits: bool) -> None:
    """Two points at range 2, along x and z, with colours of 16 bits; and a scan without points."""
    columns = {
        "sphericalRange": [2.0, 2.0],
        "sphericalAzimuth": [0.0, 0.0],
        "sphericalElevation": [0.0, np.pi / 2],
        **dict(zip(e57.COLOURS, ([65535, 0], [0, 65535], [32768, 0]), strict=True)),
    }
    with pye57.E57(str(path), mode="w") as file:
        image, lib = file.image_file, pye57.libe57
        scan, record, limits = (lib.StructureNode(image) for _ in range(3))
        buffers, arrays = lib.VectorSourceDestBuffer(), []
        for name, values in columns.items():
            if name in e57.COLOURS:
                record.set(name, lib.IntegerNode(image, 0, 0, 65535))
                limits.set(f"{name}Maximum", lib.IntegerNode(image, 65535))
            else:
                record.set(name, lib.FloatNode(image, 0.0, lib.E57_DOUBLE))
            arrays.append(np.array(values, dtype=np.float64))
            buffers.append(lib.SourceDestBuffer(image, name, arrays[-1], 2, True, True))
        points = lib.CompressedVectorNode(image, record, lib.VectorNode(image, True))
        scan.set("guid", lib.StringNode(image, "scan"))
        scan.set("points", points)
        if has_limits:
            scan.set("colorLimits", limits)
        file.data3d.append(scan)
        writer = points.writer(buffers)
        writer.write(2)
        writer.close()
        empty = lib.StructureNode(image)
        file.data3d.append(empty)
        record = lib.StructureNode(image)
        record.set("cartesianX", lib.FloatNode(image))
        empty.set("points", lib.CompressedVectorNode(image, record, lib.VectorNode(image, True)))


@pytest.mark.parametrize("has_limits", [True, False])
def test_an_e57_may_be_spherical_with_colours_of_16_bits(has_limits: bool, tmp_path: Path) -> None:
    spherical_e57(tmp_path / "a.e57", has_limits)
    found = neuralmesh.read(tmp_path / "a.e57")
    assert found.points == pytest.approx(np.array([[2, 0, 0], [0, 0, 2]]), abs=1e-12)
    assert found.colours is not None
    assert found.colours.tolist() == [[255, 0, 128], [0, 255, 0]]


# ---------------------------------------------------------------------------- STL


@pytest.fixture(scope="module")
def large_stl(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A net of 500,000 vertices, 1,000,000 triangles and 50 MB."""
    row, column = np.meshgrid(np.arange(1000), np.arange(500), indexing="ij")
    places = np.stack([row, column, row * column], -1).astype("<f4")
    a, b, c, d = places[:-1, :-1], places[1:, :-1], places[1:, 1:], places[:-1, 1:]
    triangles = np.zeros(2 * 999 * 499, stl.TRIANGLE)
    triangles["corners"] = np.stack([a, b, c, a, c, d], 2).reshape(-1, 3, 3)
    path = tmp_path_factory.mktemp("stl") / "net.stl"
    path.write_bytes(bytes(80) + len(triangles).to_bytes(4, "little") + triangles.tobytes())
    return path


def test_ctrl_c_is_heard_while_corners_are_merged(large_stl: Path) -> None:
    gaps, last = [], time.process_time()

    def listen(*_: object) -> None:
        nonlocal last
        gaps.append(time.process_time() - last)
        last = time.process_time()

    assert neuralmesh.read(large_stl, progress=listen).points.shape == (500_000, 3)
    # Python hears Ctrl-C between two reports, at the latest; a part of a second is promised.
    assert max(gaps) < 0.5


def test_a_large_stl_needs_little_memory(large_stl: Path) -> None:
    program = (
        "import resource, sys, neuralmesh, neuralmesh.files.stl\n"
        "most = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
        "before = most()\n"
        "neuralmesh.read(sys.argv[1], most_points=1000)\n"
        "print((most() - before) // 1024)\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", program, str(large_stl)], capture_output=True, text=True, check=True
    )
    # 41 MB; all corners at once, by trimesh, took 592.
    assert int(run.stdout) < 120


def test_corners_are_merged_across_blocks_and_both_zeros_are_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    trimesh.creation.icosphere(subdivisions=2).export(tmp_path / "ball.stl")
    monkeypatch.setattr(stl, "TRIANGLES", 7)
    points = neuralmesh.read(tmp_path / "ball.stl").points
    assert points.shape == np.unique(points, axis=0).shape == (162, 3)
    zeros = np.array([[0.0, 1, 2], [-0.0, 1, 2], [3, 1, 2]])
    assert stl.Merger().new_among(zeros).tolist() == [[0, 1, 2], [3, 1, 2]]


def test_what_is_not_remembered_is_merged_within_its_block(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(stl, "MOST_REMEMBERED", 1)
    merger, points = stl.Merger(), np.eye(3)
    assert len(merger.new_among(points[:1])) == 1
    assert len(merger.new_among(points[[0, 1, 2, 1]])) == 2
    assert len(merger.new_among(points[[1, 0]])) == 1
