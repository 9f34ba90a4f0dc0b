# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/batch.py: odd names, a full disk and a foreign folder cost an item, never the batch."""

from __future__ import annotations

import argparse
import json
import os
import resource
import shutil
import subprocess
from pathlib import Path

import pymeshlab
import pytest
from batches import command, csv_rows, errors, record_files, report, run_batch

from neuralmesh_tools.batching import reconstruct
from neuralmesh_tools.batching.folder import OutFolder
from neuralmesh_tools.batching.inputs import InputError, find_items, read_list
from neuralmesh_tools.batching.recipe import RecipeError, parse_settings
from neuralmesh_tools.command_line import positive
from neuralmesh_tools.files import LONGEST_NAME, fitting, shown, write_in_one_step
from neuralmesh_tools.generated_clouds import bumpy_ellipsoid, write_ply

pytestmark = pytest.mark.usefixtures("plugin")

SMALL = ("--vertices", 50, "--workers", 1)


@pytest.fixture
def cloud(tmp_path: Path) -> Path:
    """A small cloud whose copies get the names of the tests."""
    write_ply(tmp_path / "cloud.ply", bumpy_ellipsoid(300, 1))
    return tmp_path / "cloud.ply"


def copies(cloud: Path, folder: Path, names: list[str | bytes]) -> None:
    folder.mkdir(parents=True)
    for name in names:
        path = os.path.join(os.fsencode(folder), os.fsencode(name))
        os.makedirs(os.path.dirname(path), exist_ok=True)
        shutil.copy(cloud, path)


def test_names_that_something_could_trip_over_are_names_like_others(cloud: Path, tmp_path: Path):
    scans, out = tmp_path / "[/]", tmp_path / "[bold]:smile:"
    odd = ["a" * 236 + ".ply", "b" * 251 + ".ply", "[/].ply", ":x:.ply", "line\nend.ply"]
    odd += ["\x1b[31mred.ply", "..ply", "report.ply", "größe.ply", " space .ply", "-n.ply"]
    copies(cloud, scans, [*odd, b"gr\xf6\xdfe.ply"])
    inputs = (scans, scans / "..ply")  # a hidden file is no scan of a folder
    run = run_batch(*inputs, "--out", out, *SMALL)
    assert run.returncode == 0, run.stdout + run.stderr
    assert f"{len(odd) + 1} done, 0 failed" in run.stdout
    assert "\x1b" not in run.stdout
    assert str(out) in run.stdout
    outputs = {row["output"] for row in csv_rows(out)}
    assert len(outputs) == len(odd) + 1
    assert {"a" * 236 + ".ply", "[/].ply", "..ply.ply", "größe.ply", "gr%F6%DFe.ply"} <= outputs
    assert all((out / output).is_file() for output in outputs)
    again = run_batch(*inputs, "--out", out, *SMALL)
    assert f"{len(odd) + 1} of them done before" in again.stdout


def test_a_locale_without_letters_reads_all_names(cloud: Path, tmp_path: Path):
    copies(cloud, tmp_path / "scans", ["größe.ply", "点.ply"])
    run = subprocess.run(
        command(tmp_path / "scans", "--out", tmp_path / "out", *SMALL),
        env={**os.environ, "LC_ALL": "C"},
        capture_output=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert {row["output"] for row in csv_rows(tmp_path / "out")} == {"größe.ply", "点.ply"}


def test_inputs_that_cannot_be_files_fail_alone(cloud: Path, tmp_path: Path):
    loop, listed, out = tmp_path / "loop.ply", tmp_path / "list.txt", tmp_path / "out"
    loop.symlink_to(loop)
    listed.write_bytes(b"\xef\xbb\xbf" + bytes(cloud) + b"\r\n" + b"x" * 300 + b".ply\n\xff.ply\n")
    run = run_batch("--list", listed, loop, "--out", out, *SMALL)
    assert run.returncode == 1, run.stdout + run.stderr
    found = errors(out)
    assert found.pop("loop") == "There is no such file."
    assert found.pop("%FF") == "There is no such file."
    assert list(found.values()) == ["It cannot be read: File name too long."]
    assert (out / "cloud.ply").is_file()


def test_a_full_disk_is_a_failed_line_and_the_report_is_written(cloud: Path, tmp_path: Path):
    arguments = (cloud, "--out", tmp_path / "out", "--vertices", 140, "--format", "obj")
    run = subprocess.run(
        command(*arguments),
        # A write beyond it is an error, as on a full disk: Python ignores the signal.
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (9_000, 9_000)),
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert errors(tmp_path / "out")["cloud"].startswith("Its output cannot be written: ")
    assert "Traceback" not in run.stdout + run.stderr
    assert run_batch(*arguments).returncode == 0


def test_a_file_that_does_not_hold_all_is_no_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    document, other = pymeshlab.MeshSet(verbose=False), pymeshlab.MeshSet(verbose=False)
    document.create_sphere()
    other.create_tetrahedron()
    write = pymeshlab.MeshSet.save_current_mesh
    reconstruct.save(document, tmp_path / "sphere.ply")
    # As on a disk that is full when the last block is written: PyMeshLab says nothing.
    monkeypatch.setattr(pymeshlab.MeshSet, "save_current_mesh", lambda _, path: write(other, path))
    with pytest.raises(ValueError, match=r"^Its output cannot be written: not all of it is in"):
        reconstruct.save(document, tmp_path / "sphere.ply")


def test_a_record_without_room_is_reported_all_the_same(cloud: Path, tmp_path: Path):
    out = tmp_path / "out"
    (out / ".batch").mkdir(parents=True)
    (out / ".batch" / "records").touch()  # no folder: no record can be written
    run = run_batch(cloud, "--out", out, *SMALL)
    assert run.returncode == 1, run.stdout + run.stderr
    assert errors(out) == {"cloud": "It cannot be written: File exists."}


def test_a_report_without_room_is_a_line(cloud: Path, tmp_path: Path):
    (tmp_path / "out" / "report.json").mkdir(parents=True)
    run = run_batch(cloud, "--out", tmp_path / "out", *SMALL)
    assert run.returncode == 1
    assert "The report cannot be written: Is a directory" in run.stdout
    assert "Traceback" not in run.stderr


@pytest.fixture
def record() -> dict[str, object]:
    """A record as a batch keeps it, of the item `cloud`."""
    texts = dict.fromkeys(("input", "outcome", "error", "run", "warning"), "")
    return {
        **texts,
        "name": "cloud",
        "fingerprint": "0",
        "output": "cloud.ply",
        "output_bytes": 8,
        "results": {},
        "parameters": {},
        "versions": {},
        "seconds": 1.0,
    }


@pytest.mark.parametrize(
    "output", ["../victim", "../victim.ply", "{root}/victim.ply", "victim.ply"]
)
def test_a_foreign_record_removes_nothing(tmp_path: Path, record: dict[str, object], output: str):
    folder = OutFolder(tmp_path / "out")
    victims = [tmp_path / "victim", tmp_path / "victim.ply", folder.root / "victim.ply"]
    record["output"] = output.format(root=tmp_path)
    folder.write_record("cloud", record)
    for victim in victims:
        victim.write_bytes(b"precious")
    folder.remove_other_output("cloud", "cloud.stl")
    assert [victim.read_bytes() for victim in victims] == [b"precious"] * 3
    assert not folder.is_done("cloud", "0")


def test_an_output_of_another_format_is_removed_unless_it_was_changed(
    tmp_path: Path, record: dict[str, object]
):
    folder = OutFolder(tmp_path)
    folder.write_record("cloud", record)
    for content, left in ((b"somebody else's", True), (b"8 bytes.", False)):
        (tmp_path / "cloud.ply").write_bytes(content)
        folder.remove_other_output("cloud", "cloud.stl")
        assert (tmp_path / "cloud.ply").exists() == left


@pytest.mark.parametrize(
    "text",
    ["[]", "5", "[" * 100_000, "{}", '{"output": 5}', '{"fingerprint": null}', '{"results": []}'],
)
def test_what_is_no_record_is_none(tmp_path: Path, record: dict[str, object], text: str):
    folder = OutFolder(tmp_path)
    folder.write_record("cloud", record)
    assert folder.record("cloud") == record
    changed = text if text[:2] != '{"' else json.dumps(record | json.loads(text))
    (tmp_path / ".batch" / "records" / "cloud.json").write_text(changed, encoding="utf-8")
    assert folder.record("cloud") is None
    assert not folder.is_done("cloud", "0")
    folder.remove_other_output("cloud", "")


def test_a_record_without_a_fingerprint_is_done_again(cloud: Path, tmp_path: Path):
    out = tmp_path / "out"
    assert run_batch(cloud, "--out", out, *SMALL).returncode == 0
    path = out / ".batch" / "records" / "cloud.json"
    record = json.loads(path.read_text())
    del record["fingerprint"]
    path.write_text(json.dumps(record))
    run = run_batch(cloud, "--out", out, *SMALL)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "1 items, 0 of them done before" in run.stdout
    assert json.loads(record_files(out)["cloud"])["fingerprint"]


def test_links_in_the_folder_are_not_written_through(cloud: Path, tmp_path: Path):
    out, victim = tmp_path / "out", tmp_path / "victim"
    victim.write_bytes(b"precious")
    (out / "logs").mkdir(parents=True)
    for link in ("logs/cloud.log", "cloud.ply", "report.csv", "report.json"):
        (out / link).symlink_to(victim)
    run = run_batch(cloud, "--out", out, *SMALL)
    assert run.returncode == 0, run.stdout + run.stderr
    assert victim.read_bytes() == b"precious"
    assert (out / "logs" / "cloud.log").read_text().startswith(str(cloud))


@pytest.mark.parametrize("part", ["logs", ".batch/records", "deep"])
def test_folders_that_lead_elsewhere_are_not_written_to(tmp_path: Path, part: str):
    folder, elsewhere = OutFolder(tmp_path / "out"), tmp_path / "elsewhere"
    elsewhere.mkdir()
    (folder.root / part).parent.mkdir(parents=True)
    (folder.root / part).symlink_to(elsewhere)
    partial = folder.partial("run", "deep/cloud")
    partial.mkdir(parents=True)
    (partial / "cloud.ply").touch()
    with pytest.raises(OSError, match=r"a part of it is a link\.$"):  # noqa: PT012
        folder.new_log("deep/cloud")
        folder.write_record("deep/cloud", {})
        folder.move_into_place(partial, "deep/cloud", ".ply")
    assert list(elsewhere.iterdir()) == []


def test_a_state_folder_that_leads_elsewhere_stops_the_batch(cloud: Path, tmp_path: Path):
    (tmp_path / "out").mkdir()
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "out" / ".batch").symlink_to(tmp_path / "elsewhere")
    run = run_batch(cloud, "--out", tmp_path / "out", *SMALL)
    assert run.returncode == 2
    assert "a part of it is a link." in run.stderr
    assert list((tmp_path / "elsewhere").iterdir()) == []


def test_a_scan_in_a_folder_called_logs_is_a_scan(cloud: Path, tmp_path: Path):
    copies(cloud, tmp_path / "scans", [])
    (tmp_path / "scans" / "logs").mkdir()
    shutil.copy(cloud, tmp_path / "scans" / "logs")
    run = run_batch(tmp_path / "scans", "--out", tmp_path / "out", *SMALL)
    assert run.returncode == 0, run.stdout + run.stderr
    assert report(tmp_path / "out")["records"][0]["output"] == "logs/cloud.ply"


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ([""], "An input is empty: it names no file."),
        (["{cloud}", "--timeout", "nan"], "must be a positive number, not 'nan'"),
        (["{cloud}", "--out", ""], "is empty: it names no folder."),
        (["{cloud}", "--set", "Source=3"], "--set source=3 does not go with a batch: every scan"),
    ],
)
def test_what_means_something_else_is_refused_at_once(
    cloud: Path, tmp_path: Path, options: list[str], sentence: str
):
    words = [option.format(cloud=cloud) for option in options]
    where = [] if "--out" in words else ["--out", tmp_path / "out"]
    run = subprocess.run(
        command(*words, *where), capture_output=True, text=True, check=False, cwd=tmp_path
    )
    assert run.returncode == 2, run.stdout
    assert sentence in run.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("pair", "sentence"),
    [
        ("rate=nan", "rate is a number"),
        ("rate=inf%", "rate is a number"),
        ("rats=1", "The filter has no parameter rats. Is it rate?"),
        ("pointfile=a.las", "pointfile=a.las does not go with a batch: every scan would become"),
        ("startmesh=3", "startmesh=3 does not go with a batch: the document of a scan has no"),
        ("startlayer=0", "startlayer=0 does not go with a batch"),
    ],
)
def test_settings_that_cannot_be_meant_have_a_sentence(pair: str, sentence: str):
    defaults = {"rate": 0.5, "source": 0, "pointfile": "", "startmesh": 0, "startlayer": 0}
    with pytest.raises(RecipeError, match=sentence):
        parse_settings([pair], defaults)
    assert parse_settings(["source=1", "startmesh=4"], defaults) == {"source": 1, "startmesh": 4}


@pytest.mark.parametrize("text", ["nan", "inf", "0", "-1", "soon", ""])
def test_limits_are_positive_numbers(text: str):
    with pytest.raises(argparse.ArgumentTypeError, match="must be a positive number"):
        positive(text)


def test_lists_hold_bytes_and_only_line_ends_divide_them(tmp_path: Path):
    listed = tmp_path / "list"
    listed.write_bytes("a\x0bb\u2028c.ply\r\n# no\n\n".encode() + b"\xe9.ply")
    assert read_list(listed) == ["a\x0bb\u2028c.ply", "\udce9.ply"]
    listed.write_bytes(b"a\0b")
    with pytest.raises(InputError, match="holds zero bytes"):
        find_items([], [listed], tmp_path / "out")


def test_names_fit_into_a_folder_and_stay_apart():
    first, second = fitting("ü" * 200, ".ply"), fitting("ü" * 201, ".ply")
    assert first != second
    assert all(
        len(name.encode()) <= LONGEST_NAME and name.endswith(".ply") for name in (first, second)
    )
    assert fitting("a" * 246, ".ply") == "a" * 246 + ".ply"
    assert OutFolder(Path("out")).log("a/" + "b" * 250).parent == Path("out/logs/a")


def test_names_are_shown_without_what_a_terminal_obeys():
    assert shown("größe.ply") == "größe.ply"
    assert shown("a\n\x1b[2J\udcff") == r"a\n\x1b[2J\xff"


def test_a_file_that_cannot_be_written_leaves_nothing_behind(tmp_path: Path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(OSError, match="directory"):
        write_in_one_step(tmp_path / "taken", "text")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]
