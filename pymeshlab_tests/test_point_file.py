# SPDX-License-Identifier: GPL-3.0-or-later
"""A point file on disk is sampled in place, in an empty document, with the mesh of its points."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import laspy
import numpy as np
import pymeshlab
import pytest
from broken_point_files import VALID, BrokenFile, corpus
from documents import FILTER, Points, mesh_from, reconstruct, sphere_points
from numpy.typing import NDArray

from neuralmesh_tools.benchmarks.point_file import run_in_process, write_sphere

pytestmark = pytest.mark.usefixtures("plugin")

TARGET = 500


def mesh_from_file(path: Path, **parameters: object) -> tuple[Points, NDArray[np.int32]]:
    """Reconstruct a point file in an empty document; return vertices and faces."""
    document = pymeshlab.MeshSet(verbose=False)
    reconstruct(document, source=3, pointfile=str(path), **parameters)
    mesh = document.current_mesh()
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())


def refusal(document: pymeshlab.MeshSet, **parameters: object) -> str:
    """Return the sentence of the filter's error."""
    with pytest.raises(pymeshlab.PyMeshLabException) as caught:
        reconstruct(document, source=3, **parameters)
    start = f"Failed to apply filter: {FILTER}\nDetails: "
    assert str(caught.value).startswith(start)
    return str(caught.value).removeprefix(start)


def write_ply(path: Path, points: Points, kind: str) -> None:
    """Write points as binary PLY of "<f4", "<f8", ">f4" or ">f8", with a colour and a face."""
    order = "little" if kind[0] == "<" else "big"
    number = "float" if kind[1:] == "f4" else "double"
    header = [f"ply\nformat binary_{order}_endian 1.0\nelement vertex {len(points)}"]
    header += ["property uchar red", *(f"property {number} {axis}" for axis in "zyx")]
    header += ["element face 1", "property list uchar int vertex_indices", "end_header\n"]
    records = np.empty(len(points), [("red", "u1"), *((axis, kind) for axis in "zyx")])
    for axis, column in zip("xyz", points.T, strict=True):
        records[axis] = column
    face = b"\x03" + np.arange(3, dtype=kind[0] + "i4").tobytes()
    path.write_bytes("\n".join(header).encode() + records.tobytes() + face)


@pytest.mark.parametrize("kind", ["<f4", "<f8", ">f4", ">f8"])
@pytest.mark.parametrize("suffix", ["ply", "npy"])
def test_a_file_gives_the_mesh_of_the_same_points_in_memory(
    suffix: str, kind: str, bunny_array: Points, tmp_path: Path
) -> None:
    # On a grid that float32 holds, so that nothing is rounded.
    points = np.round(bunny_array * 2.0**20) / 2.0**20
    path = tmp_path / f"bunny.{suffix}"
    if suffix == "ply":
        write_ply(path, points, kind)
    else:
        np.save(path, np.ascontiguousarray(points, dtype=kind))
    vertices, faces = mesh_from_file(path, targetvertnum=TARGET)
    vertices_in_memory, faces_in_memory = mesh_from(points, targetvertnum=TARGET)
    np.testing.assert_array_equal(faces, faces_in_memory)
    np.testing.assert_array_equal(vertices, vertices_in_memory)


PROGRAM = """
import sys
import pymeshlab

pymeshlab.load_plugin(sys.argv[1])
document = pymeshlab.MeshSet(verbose=False)
print(document.apply_filter(sys.argv[2], source=3, pointfile=sys.argv[3], targetvertnum=50))
"""


@pytest.mark.parametrize("locale", ["C", "C.UTF-8"])
def test_a_name_with_letters_is_found_in_any_locale(
    plugin: Path, tmp_path: Path, locale: str
) -> None:
    np.save(tmp_path / "größe 点.npy", sphere_points(500))
    command = [sys.executable, "-c", PROGRAM, plugin, FILTER, tmp_path / "größe 点.npy"]
    environment = {**os.environ, "LC_ALL": locale}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "'vertices': 50" in done.stdout


@pytest.mark.parametrize(("version", "point_format"), [("1.2", 0), ("1.2", 3), ("1.4", 6)])
def test_a_las_file_at_utm_coordinates_gives_its_surface_in_place(
    version: str, point_format: int, tmp_path: Path
) -> None:
    centre = np.array([500_000.0, 4_500_000.0, 100.0])
    las = laspy.create(file_version=version, point_format=point_format)
    las.header.offsets = centre + 7
    las.header.scales = [0.001] * 3
    las.xyz = centre + 10 * sphere_points(20_000)
    las.write(tmp_path / "sphere.las")
    vertices, _ = mesh_from_file(tmp_path / "sphere.las", targetvertnum=TARGET)
    radii = np.linalg.norm(vertices - centre, axis=1)
    # Of 500 vertices on a sphere, the surface fit puts each half an edge's sagitta, 0.3 %, outside.
    assert np.sqrt(np.mean((radii / 10 - 1) ** 2)) < 0.005


def test_noise_and_outliers_are_met_as_in_memory(bunny_array: Points, tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    diagonal = np.linalg.norm(np.ptp(bunny_array, axis=0))
    noisy = bunny_array + rng.normal(scale=0.002 * diagonal, size=bunny_array.shape)
    low, high = noisy.min(axis=0), noisy.max(axis=0)
    points = np.vstack([noisy, rng.uniform(low, high, size=(len(noisy) // 20, 3))])
    np.save(tmp_path / "dirty.npy", points)
    document = pymeshlab.MeshSet(verbose=False)
    in_file = reconstruct(
        document, source=3, pointfile=str(tmp_path / "dirty.npy"), targetvertnum=2000
    )
    document.add_mesh(pymeshlab.Mesh(points), "dirty")
    in_memory = reconstruct(document, targetvertnum=2000)
    # The same points in other orders: seeds differ by 3 %.
    assert in_file["rms_error"] == pytest.approx(in_memory["rms_error"], rel=0.1)


def test_the_layer_is_named_after_the_file_and_others_stay(tmp_path: Path) -> None:
    np.save(tmp_path / "scan.v2.npy", sphere_points(1000))
    document = pymeshlab.MeshSet(verbose=False)
    result = reconstruct(
        document, source=3, pointfile=str(tmp_path / "scan.v2.npy"), targetvertnum=50
    )
    assert result["vertices"] == 50
    assert [mesh.label() for mesh in document] == ["scan_v2 neural mesh"]
    assert document.current_mesh_id() == 0
    np.testing.assert_array_equal(document.current_mesh().transform_matrix(), np.eye(4))


@pytest.mark.parametrize("broken", corpus(), ids=lambda broken: broken.name)
def test_a_broken_file_gets_its_own_sentence(broken: BrokenFile, tmp_path: Path) -> None:
    path = tmp_path / "broken"
    path.write_bytes(broken.content)
    document = pymeshlab.MeshSet(verbose=False)
    sentence = refusal(document, pointfile=str(path), targetvertnum=8)
    assert sentence == f"pointfile '{path}': {broken.sentence}"
    assert document.mesh_number() == 0


@pytest.mark.parametrize("name", VALID)
def test_the_corpus_is_broken_in_what_it_changes_only(name: str, tmp_path: Path) -> None:
    (tmp_path / "valid").write_bytes(VALID[name])
    vertices, _ = mesh_from_file(tmp_path / "valid", targetvertnum=4)
    assert len(vertices) == 4


def test_what_is_no_file_is_refused(mesh_set: pymeshlab.MeshSet, tmp_path: Path) -> None:
    missing = tmp_path / "missing.ply"
    assert refusal(mesh_set, pointfile=str(missing)) == (
        f"pointfile '{missing}': the file cannot be opened: No such file or directory."
    )
    assert refusal(mesh_set, pointfile=str(tmp_path)) == (
        f"pointfile '{tmp_path}': it is no ordinary file but a folder, a pipe or a device."
    )
    assert refusal(mesh_set) == "source is a point file, but pointfile names none."
    assert mesh_set.mesh_number() == 0


def test_more_vertices_than_distinct_points_are_refused(tmp_path: Path) -> None:
    np.save(tmp_path / "few.npy", np.repeat(sphere_points(50), 4, axis=0))
    document = pymeshlab.MeshSet(verbose=False)
    assert refusal(document, pointfile=str(tmp_path / "few.npy"), targetvertnum=51) == (
        "targetvertnum is 51, but there are only 50 distinct points to draw from: "
        "at most 50 vertices are possible."
    )


def test_a_file_has_no_density(tmp_path: Path) -> None:
    np.save(tmp_path / "sphere.npy", sphere_points(50))
    document = pymeshlab.MeshSet(verbose=False)
    assert refusal(document, pointfile=str(tmp_path / "sphere.npy"), densityfromquality=True) == (
        "densityfromquality is for layers: a point file has no vertex quality."
    )


def test_memory_does_not_grow_with_the_file(plugin: Path, tmp_path: Path) -> None:
    peaks = []
    for points in (100_000, 5_000_000):
        write_sphere(tmp_path / "sphere.ply", points)
        peaks.append(run_in_process(plugin, tmp_path / "sphere.ply", 200).peak_mib)
    # A loaded file would take 60 MB as it is and 120 MB in double precision.
    assert peaks[1] - peaks[0] < 10
