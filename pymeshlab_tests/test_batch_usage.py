# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/batch.py: what cannot work is said before anything runs, and nothing is written."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from batches import report, run_batch

from neuralmesh_tools.batching.inputs import InputError, Inputs, find_items
from neuralmesh_tools.batching.left_out import left_out_text
from neuralmesh_tools.batching.recipe import Recipe, RecipeError, parse_settings
from neuralmesh_tools.generated_clouds import bumpy_ellipsoid, write_clouds

pytestmark = pytest.mark.usefixtures("plugin")

SCRIPT = """<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Remove Duplicate Vertices"/>
 <filter name="Neural Mesh Reconstruction">
  <Param name="TargetVertNum" type="RichInt" value="150"/>
  <Param name="Sharpness" type="RichFloat" value="1"/>
 </filter>
 <filter name="Polish It"/>
</FilterScript>
"""


@pytest.fixture
def clouds(tmp_path: Path) -> Path:
    folder = tmp_path / "clouds"
    write_clouds(folder, 2, points=100)
    return folder


def test_unknown_filters_and_parameters_of_a_script_are_named(clouds: Path, tmp_path: Path):
    script, out = tmp_path / "script.mlx", tmp_path / "out"
    script.write_text(SCRIPT, encoding="utf-8")
    run = run_batch(clouds, "--out", out, "--mlx", script)
    assert run.returncode == 2
    assert run.stderr.splitlines() == [
        f'{script}: the filter "Neural Mesh Reconstruction" has no parameter Sharpness.',
        f'{script}: PyMeshLab has no filter "Polish It". Is its plugin missing (--plugin)?',
    ]
    assert not out.exists()


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (["--set", "sharpness=1"], "The filter has no parameter sharpness. It has: "),
        (["--set", "surfacefit=perhaps"], "surfacefit is true or false (True by default), not "),
        (["--vertices", "100", "--plugin", "none.so"], "none.so is not there: run scripts/build."),
        (["--format", "docx"], "PyMeshLab does not write .docx: Unknown format for save: docx."),
        (["--mlx", "none.mlx"], "none.mlx cannot be read as a filter script: "),
        (["--mlx", "none.mlx", "--vertices", "5"], "--set and --vertices do not go with it"),
        (["--workers", "0"], "--workers must be at least 1"),
        (["none/*.ply"], "Nothing matches none/*.ply."),
    ],
)
def test_what_cannot_work_is_said_at_once(
    clouds: Path, tmp_path: Path, options: list[str], sentence: str
):
    run = run_batch(clouds, "--out", tmp_path / "out", *options)
    assert run.returncode == 2
    assert sentence in run.stderr
    assert not (tmp_path / "out").exists()


def test_a_scheduler_that_does_not_answer_is_named(clouds: Path, tmp_path: Path):
    address = "tcp://127.0.0.1:1"
    run = run_batch(clouds, "--out", tmp_path / "out", "--scheduler", address)
    assert run.returncode == 2
    assert run.stderr.startswith(f"{address}: ")
    assert "Traceback" not in run.stderr


def names(inputs: Inputs) -> list[str]:
    return [item.name for item in inputs.items]


def test_inputs_are_files_globs_folders_and_lists_each_file_once(tmp_path: Path):
    write_clouds(tmp_path / "a" / "deep", 2, points=4)
    (tmp_path / "a" / "notes.txt").touch()
    cloud = str(tmp_path / "a" / "deep" / "cloud001.ply")
    listed = tmp_path / "list.txt"
    listed.write_text(f"# scans of May\n\n{cloud}\n{tmp_path / 'missing.xyz'}\n", encoding="utf-8")
    out = tmp_path / "out"
    assert names(find_items([str(tmp_path / "a")], [], out)) == ["deep/cloud000", "deep/cloud001"]
    assert names(find_items([f"{tmp_path}/**/*0.ply"], [], out)) == ["cloud000"]
    assert names(find_items([cloud, cloud], [listed], out)) == ["cloud001", "missing"]


def test_what_a_folder_leaves_out_is_named_and_counted(tmp_path: Path):
    folder = tmp_path / "scans"
    write_clouds(folder / "deep", 1, points=4)
    for name in ("a.las", "b.LAS", "notes.txt", "README", ".batch/partial/x.ply", "out/old.txt"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    (folder / "gone.ply").symlink_to(folder / "nowhere.ply")
    (folder / "loop").symlink_to(folder)
    found = find_items([str(folder), str(folder / "notes.txt")], [], folder / "out")
    assert names(found) == ["deep/cloud000", "notes"]
    assert left_out_text(found.left_out) == (
        "Left out: 2 × .las (a.las, b.LAS); 1 × a link that leads nowhere (gone.ply); "
        "1 × a link to a folder (loop); 1 × no ending (README)."
    )
    with pytest.raises(InputError, match=r"holds no scans\. Left out: 1 × \.txt \(old\.txt\)\.$"):
        find_items([str(folder / "out")], [], tmp_path / "out")


def test_hidden_files_and_folders_are_left_out_unless_they_are_named(tmp_path: Path):
    folder = tmp_path / "scans"
    for name in ("a.ply", "._a.ply", ".hidden.ply", ".DS_Store", ".git/b.ply"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    found = find_items([str(folder)], [], tmp_path / "out")
    assert names(found) == ["a"]
    assert left_out_text(found.left_out) == (
        "Left out: 3 × hidden (.DS_Store, ._a.ply, .hidden.ply); 1 × a hidden folder (.git)."
    )
    assert names(find_items([str(folder / ".hidden.ply")], [], tmp_path / "out")) == [".hidden"]


@pytest.mark.parametrize("pattern", ["", "/**/*"])
def test_a_batch_into_its_own_inputs_takes_no_output_for_a_scan(tmp_path: Path, pattern: str):
    folder = tmp_path / "tiles"
    for name in ("a.xyz", "deep/b.xyz"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        points = bumpy_ellipsoid(100, 1)
        np.savetxt(folder / name, points)
    arguments = (f"{folder}{pattern}", "--out", folder, "--vertices", 20)
    first, second = run_batch(*arguments), run_batch(*arguments)
    assert first.returncode == second.returncode == 0, first.stdout + second.stdout
    assert "2 items, 0 of them done before" in first.stdout
    assert "2 items, 2 of them done before" in second.stdout
    left_out = {Path(found["path"]).name: found["kind"] for found in report(folder)["left_out"]}
    written = ("a.ply", "b.ply", "a.log", "b.log", "report.csv", "report.json")
    assert left_out == dict.fromkeys(written, "written by a batch")


def test_reports_of_another_batch_are_no_scans_and_its_meshes_are(tmp_path: Path):
    for name in (".batch/run", "report.csv", "mesh.csv", "deep/report.csv"):
        (tmp_path / "meshes" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "meshes" / name).touch()
    found = find_items([str(tmp_path / "meshes")], [], tmp_path / "out", [".csv"])
    assert names(found) == ["mesh", "deep/report"]
    assert left_out_text(found.left_out) == "Left out: 1 × written by a batch (report.csv)."


def test_a_mesh_never_takes_the_place_of_a_scan(clouds: Path):
    before = {path: path.read_bytes() for path in clouds.iterdir()}
    run = run_batch(clouds, "--out", clouds, "--vertices", 20)
    assert run.returncode == 2
    assert run.stderr == (
        f"The mesh of {clouds / 'cloud000.ply'} would take the place of the scan "
        f"{clouds / 'cloud000.ply'}: choose another --out or --format.\n"
    )
    assert {path: path.read_bytes() for path in clouds.iterdir()} == before
    assert run_batch(clouds, "--out", clouds, "--format", "obj", "--vertices", 20).returncode == 0


def test_a_batch_says_what_its_folder_leaves_out(clouds: Path, tmp_path: Path):
    (clouds / "tile.laz").touch()
    run = run_batch(clouds, "--out", tmp_path / "out", "--vertices", 20)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Left out: 1 × .laz (tile.laz)." in run.stdout
    assert report(tmp_path / "out")["left_out"] == [
        {"path": str(clouds / "tile.laz"), "kind": ".laz"}
    ]


def test_inputs_of_one_name_keep_apart(tmp_path: Path):
    for folder in ("a", "b", "b/sub"):
        (tmp_path / folder).mkdir()
    files = ["a/one.ply", "a/two.ply", "a/two.xyz", "a/three.ply", "b/three.ply", "b/Three.PLY"]
    files += ["b/sub/four.ply", "a/four.ply", "a/two.ply.off"]
    for file in files:
        (tmp_path / file).touch()
    found = names(find_items([str(tmp_path / file) for file in files], [], tmp_path / "out"))
    assert found[:3] == ["one", "a/two.ply", "two.xyz"]
    assert found[3] == "a/three.ply"
    assert found[6:] == ["sub/four.ply", "a/four.ply", "two.ply.off"]
    # Where case does not count, these two are one name: a hash of their paths tells them apart.
    assert [name.split("-")[0] for name in found[4:6]] == ["three.ply", "Three.PLY"]
    assert len({name.casefold() for name in found}) == len(files)
    in_a_folder = names(find_items([str(tmp_path / "a")], [], tmp_path / "out"))
    assert in_a_folder[0] == "four"
    assert {"two.xyz", "three", "one"} < set(in_a_folder)


def test_values_take_the_type_of_the_default():
    defaults = {"count": 5, "rate": 0.5, "fit": True, "file": "", "colour": None}
    pairs = ["Count=7", "rate=5%", "fit=False", "file=a=b"]
    assert parse_settings(pairs, defaults) == {
        "count": 7,
        "rate": "5%",
        "fit": False,
        "file": "a=b",
    }
    for wrong in ("count=7.5", "rate=much", "rate=x%", "fit=2", "colour=red", "count"):
        with pytest.raises(RecipeError):
            parse_settings([wrong], defaults)


def test_a_fingerprint_tells_apart_what_changes_the_output_and_only_that():
    def recipe(**changes: object) -> Recipe:
        kept = {"filter": "f", "parameters": {"a": 1, "b": 2}, "script": "", "suffix": ".ply"}
        return Recipe(plugins=(), **{**kept, **changes})

    same = [recipe(), recipe(parameters={"b": 2, "a": 1}), recipe(threads=2)]
    others = [
        recipe(parameters={"a": 1, "b": 3}),
        recipe(filter="g"),
        recipe(script="<FilterScript/>"),
        recipe(suffix=".obj"),
        recipe(versions={"pymeshlab": "2026.1"}),
    ]
    assert len({recipe.fingerprint("input") for recipe in same}) == 1
    assert len({recipe.fingerprint("input") for recipe in [*same, *others]}) == 1 + len(others)
    assert recipe().fingerprint("another input") != recipe().fingerprint("input")
