# SPDX-License-Identifier: GPL-3.0-or-later
"""A batch from its settings to its report: check, see what is to be done, do it, report."""

from __future__ import annotations

import signal
import time
import uuid
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.text import Text

from neuralmesh_tools.batching import report
from neuralmesh_tools.batching.engine import run_jobs
from neuralmesh_tools.batching.folder import OutFolder, Record
from neuralmesh_tools.batching.inputs import InputError, Inputs, Item
from neuralmesh_tools.batching.left_out import left_out_text
from neuralmesh_tools.batching.recipe import Recipe
from neuralmesh_tools.batching.work import Job
from neuralmesh_tools.files import sha256_of, shown

INTERRUPTED = 130  # what a shell reports of a program that Ctrl-C ended


@dataclass(frozen=True)
class Settings:
    """How a batch is run. timeout in seconds, memory_limit in bytes (0: none), an item each."""

    out: Path
    workers: int
    scheduler: str
    timeout: float
    memory_limit: int
    recycle_after: int


def run_batch(inputs: Inputs, recipe: Recipe, settings: Settings, console: Console) -> int:
    """Do what is not done yet, write the report, and return the exit code.

    0: all items have their output. 1: some have failed, or there is no room for the report. 130:
    stopped by Ctrl-C or SIGTERM.
    Raises folder.Locked if another batch works in the folder, OSError if that cannot be written to
    or a scheduler does not answer, InputError if an output would take the place of a scan.
    """
    items = inputs.items
    folder = OutFolder(settings.out.resolve())
    _require_scans_kept(items, folder, recipe.suffix)
    run = f"{time.strftime('%Y%m%d-%H%M%S')}-{uuid.uuid4().hex[:8]}"
    interrupted = False
    with folder.locked(run), _sigterm_is_ctrl_c():
        jobs = [
            Job(
                item,
                recipe,
                sha256,
                folder.root,
                run,
                settings.timeout,
                settings.memory_limit,
                settings.recycle_after,
            )
            for item, sha256 in zip(items, _hashes(items), strict=True)
        ]
        to_do = [job for job in jobs if not folder.is_done(job.item.name, job.fingerprint)]
        console.print(f"{len(items)} items, {len(items) - len(to_do)} of them done before")
        if inputs.left_out:
            console.print(shown(left_out_text(inputs.left_out)), soft_wrap=True)
        new: dict[str, Record] = {}
        try:
            if to_do:
                _do(to_do, settings, console, new)
        except KeyboardInterrupt:
            interrupted = True
        folder.clear_partial()  # on a full disk, the report needs the room
        # A record that could not be kept is in memory only.
        records = [new.get(job.item.name) or _final_record(folder, job) for job in jobs]
        unwritten = _write_report(folder, records, recipe, inputs, console)
    code = _say_what_came_out(records, folder, interrupted, console)
    return code or int(unwritten)


def _require_scans_kept(items: list[Item], folder: OutFolder, suffix: str) -> None:
    """Raise InputError where an output would take the place of a scan of the batch."""
    sources = {item.source for item in items}
    for item in items:
        output = folder.output(item.name, suffix)
        if output in sources:
            raise InputError(
                f"The mesh of {item.source} would take the place of the scan {output}: "
                "choose another --out or --format."
            )


def _write_report(
    folder: OutFolder, records: list[Record], recipe: Recipe, inputs: Inputs, console: Console
) -> bool:
    """Write the report; say so, and return True, if there is no way to."""
    try:
        report.write_report(folder, records, recipe, inputs.left_out)
    except OSError as problem:
        line = f"The report cannot be written: {problem.strerror or problem}"
        console.print(Text(line, style="red"), soft_wrap=True)
        return True
    return False


def _hashes(items: list[Item]) -> Iterator[str]:
    """The SHA-256 of each input; empty for one that cannot be read, which its job will report."""

    def hash_or_nothing(item: Item) -> str:
        try:
            return sha256_of(item.source) if item.source.is_file() else ""
        except OSError:  # a name that is too long, too
            return ""

    with ThreadPoolExecutor() as pool:
        yield from pool.map(hash_or_nothing, items)


def _do(jobs: list[Job], settings: Settings, console: Console, done: dict[str, Record]) -> None:
    """Run the jobs; their records come into done, by name, as they finish."""
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[failed]}"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console) as progress:
        bar = progress.add_task("reconstructing", total=len(jobs), failed="")
        failed = 0
        running = run_jobs(jobs, workers=settings.workers, scheduler=settings.scheduler)
        with closing(running) as records:  # on Ctrl-C too, before the report is written
            for record in records:
                done[record["name"]] = record
                failed += bool(record["error"])
                if what := record["error"] or record["warning"]:
                    style = "red" if record["error"] else "yellow"
                    line = Text(shown(f"{record['name']}: {what}"), style=style)
                    progress.console.print(line, soft_wrap=True)
                progress.update(bar, advance=1, failed=f"{failed} failed" if failed else "")


def _final_record(folder: OutFolder, job: Job) -> Record:
    """The record of a job, of this run or of an earlier one with the same fingerprint."""
    record = folder.record(job.item.name)
    if record and record["fingerprint"] == job.fingerprint:
        return record
    return report.pending_record(job.item)


def _say_what_came_out(
    records: list[Record], folder: OutFolder, interrupted: bool, console: Console
) -> int:
    failed = sum(bool(record["error"]) for record in records)
    pending = sum(record["outcome"] == "pending" for record in records)
    done = len(records) - failed
    if interrupted:
        console.print(f"stopped; {done} done, {failed - pending} failed, {pending} to do")
        console.print("the same command goes on from here")
        return INTERRUPTED
    doubtful = sum(bool(record.get("warning")) for record in records)
    warned = f", {doubtful} of them with a warning" if doubtful else ""
    figures = f"{done} done{warned}, {failed} failed"
    console.print(shown(f"{figures}; {folder.root / 'report.csv'}"), soft_wrap=True)
    return 1 if failed else 0


@contextmanager
def _sigterm_is_ctrl_c() -> Iterator[None]:
    """Stop as cleanly on SIGTERM, which batch systems send, as on Ctrl-C."""
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
