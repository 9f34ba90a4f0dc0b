# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/batch.py on a Dask scheduler with workers of its own, one of which is lost on the way."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from batches import record_files, report, run_batch, start_batch, wait_for

from neuralmesh_tools.generated_clouds import write_clouds

pytestmark = pytest.mark.usefixtures("plugin")


@contextmanager
def dask(folder: Path, *arguments: str) -> Iterator[subprocess.Popen[bytes]]:
    """Start a dask command in a folder, without a hint where this project is; end it at last."""
    folder.mkdir()
    process = subprocess.Popen(
        [sys.executable, "-m", "distributed.cli." + arguments[0], *arguments[1:]],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@contextmanager
def cluster(folder: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """A scheduler and two worker processes on the loopback: its address, and the workers."""
    address = folder / "scheduler.json"
    with ExitStack() as stack:
        stack.enter_context(
            dask(
                folder / "scheduler",
                "dask_scheduler",
                *("--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(address)),
                *("--dashboard-address", "127.0.0.1:0", "--no-dashboard"),
            )
        )
        wait_for(address.exists, "the scheduler")
        workers = [
            stack.enter_context(
                dask(
                    folder / f"worker{number}",
                    "dask_worker",
                    *("--scheduler-file", str(address), "--host", "127.0.0.1"),
                    *("--nthreads", "1", "--no-nanny", "--no-dashboard"),
                )
            )
            for number in range(2)
        ]
        yield json.loads(address.read_text(encoding="utf-8"))["address"], workers


def test_every_item_is_done_once_although_a_worker_is_killed(tmp_path: Path):
    clouds, out, count = tmp_path / "clouds", tmp_path / "out", 24
    names = {path.stem for path in write_clouds(clouds, count)}

    def done_by() -> dict[str, set[int]]:
        """The items that each worker has done so far."""
        done: dict[str, set[int]] = {}
        for name, text in record_files(out).items():
            done.setdefault(json.loads(text)["worker"], set()).add(name)
        return done

    with cluster(tmp_path) as (address, workers):
        batch = start_batch(clouds, "--out", out, "--vertices", 1000, "--scheduler", address)
        lost, kept = workers[0].pid, workers[1].pid
        wait_for(lambda: {lost, kept} <= set(done_by()), "both workers to do an item")
        workers[0].send_signal(signal.SIGKILL)
        workers[0].wait()
        by_the_lost = done_by()[lost]
        assert len(record_files(out)) < count  # else nothing was lost
        output, _ = batch.communicate(timeout=200)
        assert batch.returncode == 0, output
        again = run_batch(clouds, "--out", out, "--vertices", 1000, "--scheduler", address)

    records = report(out)["records"]
    assert [record["name"] for record in records] == sorted(names)
    assert {record["results"]["vertices"] for record in records} == {1000}
    assert {path.stem for path in out.glob("*.ply")} == names
    assert done_by()[lost] == by_the_lost
    assert done_by()[kept] == names - by_the_lost
    assert again.returncode == 0
    assert f"{count} of them done before" in again.stdout


def test_results_that_are_lost_before_they_are_read_are_no_failures(tmp_path: Path):
    clouds, out, count = tmp_path / "clouds", tmp_path / "out", 8
    write_clouds(clouds, count)
    with cluster(tmp_path) as (address, workers):
        batch = start_batch(clouds, "--out", out, "--vertices", 1000, "--scheduler", address)
        wait_for(lambda: len(record_files(out)) > 0, "an item to be done")
        # The batch reads nothing while the workers do all the rest and one of them is lost.
        batch.send_signal(signal.SIGSTOP)
        wait_for(lambda: len(record_files(out)) == count, "all items to be done")
        workers[0].send_signal(signal.SIGKILL)
        workers[0].wait()
        batch.send_signal(signal.SIGCONT)
        output, _ = batch.communicate(timeout=200)
    assert batch.returncode == 0, output
    assert [record["outcome"] for record in report(out)["records"]] == ["returned"] * count
