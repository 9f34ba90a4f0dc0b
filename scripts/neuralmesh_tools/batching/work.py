# SPDX-License-Identifier: GPL-3.0-or-later
"""A worker's task: one item in an isolated process, its output put into place, its record kept."""

from __future__ import annotations

import contextlib
import os
import shutil
import socket
import threading
import time
from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.batching.folder import OutFolder, Record
from neuralmesh_tools.batching.inputs import Item
from neuralmesh_tools.batching.recipe import Recipe
from neuralmesh_tools.doubts import doubts
from neuralmesh_tools.files import shown
from neuralmesh_tools.isolation import IsolatedProcess, Outcome


@dataclass(frozen=True)
class Job:
    """An item, what is done to it, and within what limits (seconds; bytes, 0 for none)."""

    item: Item
    recipe: Recipe
    input_sha256: str
    out: Path
    run: str
    timeout: float
    memory_limit: int
    recycle_after: int

    @property
    def fingerprint(self) -> str:
        """What a rerun compares to know whether the output is still that of this job."""
        return self.recipe.fingerprint(self.input_sha256)


_local = threading.local()


def _process(job: Job) -> IsolatedProcess:
    """The isolated process of this thread of this worker, kept from job to job."""
    if getattr(_local, "run", None) != job.run:
        end_process()
        threads = str(job.recipe.threads)
        _local.process = IsolatedProcess(
            {"OMP_NUM_THREADS": threads}, recycle_after=job.recycle_after
        )
        _local.run = job.run
    kept: IsolatedProcess = _local.process
    return kept


def end_process() -> None:
    """End the isolated process of this thread, if there is one."""
    if hasattr(_local, "process"):
        _local.process.close()
        del _local.process, _local.run


def kept_record(job: Job) -> Record | None:
    """Return the record that this run has kept of a job, None if it has not been done yet."""
    record = OutFolder(job.out).record(job.item.name)
    return record if record and record["run"] == job.run else None


def do_job(job: Job, stop: threading.Event | None = None) -> Record:
    """Do a job, keep its record in the output folder, and return it. Failures are records too.

    Once stop is set, the item's process is killed, and Stopped is raised: there is no record then.

    A job that Dask hands out again, because its worker was lost after the record was kept, is not
    done a second time.
    """
    if earlier := kept_record(job):
        return earlier
    try:
        return _do(job, stop)
    except OSError as problem:  # a full disk, a name that is too long, a folder that is a link
        return kept_failure(job, "not written", f"It cannot be written: {_words(problem)}")


def kept_failure(job: Job, kind: str, failure: str) -> Record:
    """Record that a job failed, and keep the record where there is room for it."""
    folder, name = OutFolder(job.out), job.item.name
    record = record_of(job, Outcome(kind, None, failure, 0.0, 0))
    if folder.is_current(job.run):
        with contextlib.suppress(OSError):
            folder.remove_other_output(name, "")
        with contextlib.suppress(OSError):
            folder.write_record(name, record)
    return record


def _words(problem: OSError) -> str:
    words = " ".join((problem.strerror or str(problem)).split())
    return words if words.endswith(".") else words + "."


def _do(job: Job, stop: threading.Event | None) -> Record:
    folder = OutFolder(job.out)
    name = job.item.name
    partial = folder.partial(job.run, name)
    shutil.rmtree(partial, ignore_errors=True)
    folder.make_room_for(partial / "output")
    log = folder.new_log(name)
    outcome = _reconstruct(job, partial, log, stop)
    printed = log.read_text(encoding="utf-8", errors="replace") if outcome.ok else ""
    record = record_of(job, outcome, printed)
    if not folder.is_current(job.run):
        return record
    if outcome.ok:
        output = folder.move_into_place(partial, name, job.recipe.suffix)
        record["output"] = output.relative_to(job.out).as_posix()
        record["output_bytes"] = output.stat().st_size
    folder.remove_other_output(name, record["output"])
    folder.write_record(name, record)
    shutil.rmtree(partial, ignore_errors=True)
    return record


def _reconstruct(job: Job, partial: Path, log: Path, stop: threading.Event | None) -> Outcome:
    """Run the item in the isolated process; its log has the input before, the outcome after it."""
    log.write_text(f"{shown(job.item.source)}\n", encoding="utf-8")
    outcome = _process(job).call(
        job.recipe.by,
        job.recipe,
        str(job.item.source),
        str(partial / OutFolder(job.out).output(job.item.name, job.recipe.suffix).name),
        cpu_timeout=job.timeout * job.recipe.threads,
        memory_limit=job.memory_limit,
        log=log,
        folder=partial,
        stop=stop,
    )
    with log.open("a", encoding="utf-8") as stream:
        stream.write(f"{shown(outcome.failure) or 'Done.'} ({outcome.seconds:.2f} s)\n")
    return outcome


def record_of(job: Job, outcome: Outcome, log: str = "") -> Record:
    """A record of an outcome that has no output (yet); log: what the filters printed."""
    recipe = job.recipe
    results = outcome.value or {}
    return {
        "name": job.item.name,
        "input": shown(job.item.source),
        "input_sha256": job.input_sha256,
        "fingerprint": job.fingerprint,
        "filter": "" if recipe.script else recipe.filter,
        "parameters": {} if recipe.script else recipe.parameters,
        "script": recipe.script,
        "seed": results.get("seed"),
        "versions": recipe.versions,
        "output": "",
        "output_bytes": 0,
        "outcome": outcome.kind,
        "error": shown(outcome.failure),
        "warning": shown(doubts(results, log)),
        "seconds": round(outcome.seconds, 3),
        "peak_megabytes": round(outcome.peak_bytes / 2**20, 1),
        "results": results,
        "finished": time.strftime("%Y-%m-%dT%H:%M:%S%z"),
        "host": socket.gethostname(),
        "worker": os.getpid(),
        "run": job.run,
    }
