# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/batch.py: what fails costs its item only, and nothing that is done is done again."""

from __future__ import annotations

import json
import os
import signal
from pathlib import Path

import numpy as np
import psutil
import pymeshlab
import pytest
from batches import csv_rows, errors, record_files, report, run_batch, start_batch, wait_for

from neuralmesh_tools.generated_clouds import bumpy_ellipsoid, write_clouds, write_ply

pytestmark = pytest.mark.usefixtures("plugin")

NORMALS_THEN_MESH = """<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Compute normals for point sets">
  <Param name="K" type="RichInt" value="16"/>
 </filter>
 <filter name="Neural Mesh Reconstruction">
  <Param name="TargetVertNum" type="RichInt" value="150"/>
 </filter>
</FilterScript>
"""
# Normals of a million points take about 10 s, those of 2,000 about 10 ms.
TIME_OUT = 4


@pytest.fixture
def normals_then_mesh(tmp_path: Path) -> Path:
    """A filter script of one filter that is slow on large clouds, and ours."""
    script = tmp_path / "script.mlx"
    script.write_text(NORMALS_THEN_MESH, encoding="utf-8")
    return script


def write_broken(folder: Path) -> dict[str, str]:
    """Write clouds that are broken in five ways and one that takes too long: errors by name."""
    (folder / "empty.ply").touch()
    (folder / "header.ply").write_text("ply\nformat ascii 1.0\nelement vert", encoding="utf-8")
    (folder / "prose.xyz").write_text("these are no coordinates\n", encoding="utf-8")
    write_ply(folder / "three.ply", np.eye(3))
    write_ply(folder / "cut.ply", bumpy_ellipsoid(1000, 0))
    os.truncate(folder / "cut.ply", 6000)
    write_ply(folder / "endless.ply", bumpy_ellipsoid(1_000_000, 0))
    return {
        "empty": "It cannot be read: Eof in header.",
        "header": "The process crashed with SIGSEGV.",  # in PyMeshLab's reader
        "prose": "No points of it can be read: its first line is 'these are no coordinates'.",
        "three": "Only 3 distinct points: a closed surface needs at least 4.",
        "cut": "It cannot be read: Unexpected EOF.",
        "endless": f"It timed out: it was not done after computing for {TIME_OUT} s.",
    }


def test_broken_and_endless_scans_cost_themselves_only(
    tmp_path: Path, normals_then_mesh: Path, cloud_count: int
):
    clouds, out = tmp_path / "clouds", tmp_path / "out"
    good = {path.stem for path in write_clouds(clouds, cloud_count - 6)}
    broken = write_broken(clouds)
    run = run_batch(clouds, "--out", out, "--mlx", normals_then_mesh, "--timeout", TIME_OUT)
    assert run.returncode == 1, run.stdout + run.stderr
    assert errors(out) == broken
    assert {path.stem for path in out.glob("*.ply")} == good
    assert f"{len(good)} done, 6 failed" in run.stdout
    assert {path.stem for path in (out / "logs").iterdir()} == good | set(broken)
    rows = csv_rows(out)
    assert len(rows) == cloud_count
    assert {row["vertices"] for row in rows if not row["error"]} == {"150"}


def test_a_killed_batch_goes_on_where_it_was(
    tmp_path: Path, normals_then_mesh: Path, cloud_count: int
):
    clouds, out = tmp_path / "clouds", tmp_path / "out"
    good = {path.stem for path in write_clouds(clouds, cloud_count - 6)}
    broken = write_broken(clouds)
    arguments = (clouds, "--out", out, "--mlx", normals_then_mesh, "--timeout", TIME_OUT)
    killed = start_batch(*arguments, "--workers", 2)
    wait_for(lambda: len(record_files(out)) >= cloud_count // 2, "half of the items")
    helpers = psutil.Process(killed.pid).children(recursive=True)
    killed.kill()
    killed.communicate()
    psutil.wait_procs(helpers, timeout=60)  # what was in flight may still finish
    done_before = record_files(out)
    assert set(done_before) < good  # else the kill came too late to show anything
    assert not (out / "report.json").exists()
    times = {name: (out / f"{name}.ply").stat().st_mtime_ns for name in done_before}

    run = run_batch(*arguments)
    assert run.returncode == 1, run.stdout + run.stderr
    assert f"{len(done_before)} of them done before" in run.stdout
    assert errors(out) == broken
    assert {path.stem for path in out.glob("*.ply")} == good
    after = record_files(out)
    assert set(after) == good | set(broken)
    assert {name: after[name] for name in done_before} == done_before
    assert {name: (out / f"{name}.ply").stat().st_mtime_ns for name in done_before} == times


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGTERM])
def test_a_stopped_batch_reports_what_is_done_and_leaves_no_process(tmp_path: Path, stop: int):
    clouds, out = tmp_path / "clouds", tmp_path / "out"
    count = 400  # far more than are done while the second batch starts
    write_clouds(clouds, count)
    arguments = (clouds, "--out", out, "--vertices", 1000, "--workers", 2)
    stopped = start_batch(*arguments)
    wait_for(lambda: len(record_files(out)) >= 2, "the first items")
    helpers = psutil.Process(stopped.pid).children(recursive=True)
    second = run_batch(*arguments)
    assert second.returncode == 2
    assert second.stderr == f"Another batch is at work in {out}.\n"
    stopped.send_signal(stop)
    output, _ = stopped.communicate(timeout=60)
    assert stopped.returncode == 130, output
    assert "Traceback" not in output
    assert "the same command goes on from here" in output
    _, alive = psutil.wait_procs(helpers, timeout=20)
    assert not alive
    outcomes = [record["outcome"] for record in report(out)["records"]]
    assert outcomes.count("returned") == len(record_files(out)) < len(outcomes) == count
    assert outcomes.count("pending") == count - outcomes.count("returned")


def test_a_rerun_does_what_is_missing_or_changed_only(tmp_path: Path):
    clouds, out = tmp_path / "clouds", tmp_path / "out"
    paths = write_clouds(clouds, 5)
    write_ply(clouds / "three.ply", np.eye(3))
    arguments = (clouds, "--out", out, "--vertices", 100)
    assert run_batch(*arguments).returncode == 1
    first = record_files(out)

    (out / "cloud001.ply").unlink()
    write_ply(paths[2], bumpy_ellipsoid(500, 99))
    write_ply(clouds / "three.ply", bumpy_ellipsoid(500, 98))
    run = run_batch(*arguments)
    assert run.returncode == 0, run.stdout + run.stderr
    second = record_files(out)
    changed = {name for name in first if first[name] != second[name]}
    assert changed == {"cloud001", "cloud002", "three"}

    run = run_batch(*arguments)
    assert (run.returncode, record_files(out)) == (0, second)
    run = run_batch(clouds, "--out", out, "--vertices", 101, "--set", "surfacefit=false")
    assert run.returncode == 0
    records = report(out)["records"]
    assert {record["run"] for record in records}.isdisjoint(
        {json.loads(text)["run"] for text in second.values()}
    )
    assert {record["results"]["vertices"] for record in records} == {101}
    assert records[0]["parameters"] == {"targetvertnum": 101, "surfacefit": False}


def test_an_output_whose_new_input_fails_is_removed(tmp_path: Path):
    cloud, out = write_clouds(tmp_path / "clouds", 1)[0], tmp_path / "out"
    assert run_batch(cloud, "--out", out, "--vertices", 100).returncode == 0
    write_ply(cloud, np.eye(3))
    assert run_batch(cloud, "--out", out, "--vertices", 100).returncode == 1
    assert not (out / "cloud000.ply").exists()


def test_memory_beyond_the_limit_costs_the_item(tmp_path: Path):
    clouds, out = tmp_path / "clouds", tmp_path / "out"
    write_clouds(clouds, 1)
    write_ply(clouds / "large.ply", bumpy_ellipsoid(4_000_000, 0))
    run = run_batch(clouds, "--out", out, "--vertices", 100, "--memory", 250)
    assert run.returncode == 1, run.stdout + run.stderr
    assert errors(out) == {"large": "It needed more than the 250 MB allowed."}


def test_outputs_keep_their_place_and_take_the_format_asked_for(tmp_path: Path):
    write_clouds(tmp_path / "clouds" / "a", 1)
    write_clouds(tmp_path / "clouds" / "b", 1)
    out = tmp_path / "clouds" / "out"  # inside the inputs: its contents are no inputs
    arguments = (tmp_path / "clouds", "--out", out, "--vertices", 100, "--format", "OBJ")
    assert run_batch(*arguments).returncode == 0
    assert run_batch(*arguments).returncode == 0
    assert [record["output"] for record in report(out)["records"]] == [
        "a/cloud000.obj",
        "b/cloud000.obj",
    ]
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(out / "a" / "cloud000.obj"))
    assert document.current_mesh().vertex_number() == 100
