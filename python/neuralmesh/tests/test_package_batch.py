# SPDX-License-Identifier: GPL-3.0-or-later
"""`neuralmesh batch`: every format, and what fails is named and costs itself only."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import commands
import neuralmesh
import numpy as np
import pytest
import trimesh
from neuralmesh.command import main
from point_files import WRITERS, Points, ply

from neuralmesh_tools.project import ROOT

VERTICES = 200
# WRITERS has one for each format; these are written beside them.
MORE_OF_A_FORMAT = 12


def report(out: Path) -> dict[str, Any]:
    return json.loads((out / "report.json").read_text("utf-8"))


def write_all(folder: Path, points: Points) -> int:
    """Write 36 files: all formats, two of one name, one that is broken."""
    folder.mkdir()
    colours = np.full((len(points), 3), [200, 100, 0], np.uint8)
    for name, writer, *_ in WRITERS:
        writer(folder / name, points, colours)
    trimesh.creation.icosphere(subdivisions=3).export(folder / "ball.stl")
    shutil.copy(folder / "plain.xyz", folder / "plain.asc")
    shutil.copy(folder / "plain.xyz", folder / "colours.xyzrgb")
    shutil.copy(folder / "scan.laz", folder / "broken.laz")
    with (folder / "broken.laz").open("rb+") as file:
        file.truncate(3000)
    for number in range(MORE_OF_A_FORMAT):
        ply(folder / f"more{number:02}.ply", np.roll(points, number, axis=1), colours)
    return len(WRITERS) + 4 + MORE_OF_A_FORMAT


@pytest.fixture(scope="module")
def small_ball(ball: Points) -> Points:
    return np.round(ball[:1000], 6)


def test_36_mixed_files_are_each_done_or_named_with_the_reason(
    small_ball: Points, tmp_path: Path
) -> None:
    scans, out = tmp_path / "scans", tmp_path / "out"
    assert write_all(scans, small_ball) == 36
    (scans / "README").touch()
    (scans / "photo.jpg").touch()
    beside = {path.name for path in scans.glob("*.bin")}  # the numbers of the glTF
    assert beside
    run = commands.run("batch", scans, "--out", out, "-n", VERTICES)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "35 done, 1 failed" in run.stdout
    assert "broken: It is cut short or broken: its header promises 1,000 points, " in run.stdout
    assert f"{len(beside)} × .bin (" in run.stdout
    assert "1 × .jpg (photo.jpg); 1 × no ending (README)." in run.stdout

    found = report(out)
    assert len(found["left_out"]) == 2 + len(beside)
    records = {record["name"]: record for record in found["records"]}
    assert len(records) == 36
    errors = {name: record["error"] for name, record in records.items() if record["error"]}
    assert list(errors) == ["broken"]
    assert {
        record["results"]["vertices"] for record in records.values() if not record["error"]
    } == {VERTICES}
    made = {path.name for path in out.glob("*.ply")}
    assert {"scan.las.ply", "scan.laz.ply", "scan.e57.ply"} <= made  # of one name
    assert len(made) == 35
    for name in ("scan.las", "octree.copc", "leica"):
        expected = neuralmesh.reconstruct(records[name]["input"], VERTICES)
        assert np.array_equal(neuralmesh.read(out / f"{name}.ply").points, expected.vertices)


def test_parameters_are_those_of_the_command_and_a_rerun_does_what_changed(
    small_ball: Points, tmp_path: Path
) -> None:
    np.save(tmp_path / "a.npy", small_ball)
    np.save(tmp_path / "b.npy", small_ball[::2])
    out = tmp_path / "out"
    arguments = [tmp_path / "a.npy", tmp_path / "b.npy", "--out", out, "--format", "npz"]
    arguments += ["-n", 100, "--topology", "start", "--start-mesh", "icosahedron"]
    assert commands.run("batch", *arguments, "--no-surface-fit").returncode == 0
    expected = neuralmesh.reconstruct(
        small_ball, 100, topology="start", start_mesh="icosahedron", surface_fit=False
    )
    assert np.array_equal(np.load(out / "a.npz")["vertices"], expected.vertices)
    assert report(out)["recipe"]["versions"]["neuralmesh"] == neuralmesh.__version__

    np.save(tmp_path / "b.npy", small_ball[::3])
    run = commands.run("batch", *arguments, "--no-surface-fit", "--threads", 2)
    assert "2 items, 1 of them done before" in run.stdout
    run = commands.run("batch", *arguments)
    assert "2 items, 0 of them done before" in run.stdout


def test_a_mesh_that_is_not_to_be_trusted_has_a_warning(tmp_path: Path) -> None:
    np.save(tmp_path / "noise.npy", np.random.default_rng(0).random((400, 3)))
    run = commands.run("batch", tmp_path / "noise.npy", "--out", tmp_path / "out")
    assert run.returncode == 0, run.stdout + run.stderr
    (record,) = report(tmp_path / "out")["records"]
    assert record["warning"]
    assert record["warning"] in " ".join(run.stdout.split())


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["-n", "3"], "-n/--vertices: must be at least 4, not 3"),
        (["-n", "many"], "-n/--vertices: must be a whole number"),
        (["--format", "docx"], "--format must be one of .ply, .obj, .off, .npz, .stl, .glb"),
        (["--winner-rate", "2"], "--winner-rate must lie between 0 and 1"),
        (["--most-points", "-1"], "--most-points must be at least 0"),
        (["none/*.ply"], "Nothing matches none/*.ply."),
        (["--workers", "0"], "--workers must be at least 1"),
    ],
)
def test_what_cannot_work_is_said_before_anything_runs(
    options: list[str], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    np.save(tmp_path / "a.npy", np.eye(3))
    try:
        code = main(["batch", str(tmp_path / "a.npy"), "--out", str(tmp_path / "out"), *options])
    except SystemExit as ended:
        code = ended.code
    assert code == 2
    assert sentence in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["batch", "compare"])
def test_options_that_a_document_explains_are_there(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (ROOT / f"docs/{name}.md").read_text("utf-8")
    rows = re.findall(r"^\| `(--[\w-]+).*?\| (.*)", text, re.MULTILINE)
    explained = [option for option, words in rows if not words.startswith("of `scripts/")]
    with pytest.raises(SystemExit):
        main([name, "--help"])
    shown = capsys.readouterr().out
    assert len(explained) >= 6
    assert [option for option in explained if option not in shown] == []


def test_a_long_name_and_a_full_list(small_ball: Points, tmp_path: Path) -> None:
    name = "ü" * 123
    np.save(tmp_path / f"{name}.npy", small_ball)
    (tmp_path / "list.txt").write_text(f"{tmp_path / name}.npy\n{tmp_path}/gone.e57\n", "utf-8")
    out = tmp_path / "out"
    run = commands.run("batch", "--list", tmp_path / "list.txt", "--out", out, "-n", 50)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "gone: There is no such file." in run.stdout
    assert (out / f"{name}.ply").is_file()
