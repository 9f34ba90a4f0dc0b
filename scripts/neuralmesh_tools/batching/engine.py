# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs on this machine: a thread for each worker, each with an isolated process of its own."""

from __future__ import annotations

import threading
from collections.abc import Generator
from queue import Empty, SimpleQueue

from neuralmesh_tools.batching.folder import Record
from neuralmesh_tools.batching.work import Job, do_job, end_process, kept_failure
from neuralmesh_tools.isolation import Stopped


def run_jobs(jobs: list[Job], *, workers: int, scheduler: str) -> Generator[Record, None, None]:
    """Yield the record of each job as it finishes.

    workers: items at a time on this machine; not used if scheduler, the address of a Dask
    scheduler, is given. When the caller stops early, what has not started is left, and what runs
    is killed. Raises OSError if the scheduler does not answer, ImportError if there is no Dask.
    """
    if scheduler:
        from neuralmesh_tools.batching.cluster import run_on_cluster

        yield from run_on_cluster(jobs, scheduler)
    else:
        yield from _run_here(jobs, workers)


def _run_here(jobs: list[Job], workers: int) -> Generator[Record, None, None]:
    waiting: SimpleQueue[Job] = SimpleQueue()
    for job in jobs:
        waiting.put(job)
    done: SimpleQueue[Record] = SimpleQueue()
    stop = threading.Event()
    threads = [
        threading.Thread(target=_work, args=(waiting, done, stop))
        for _ in range(min(workers, len(jobs)))
    ]
    try:
        for thread in threads:
            thread.start()
        for _ in jobs:
            yield done.get()
    finally:
        stop.set()
        for thread in threads:
            if thread.ident is not None:  # not one that Ctrl-C came before
                thread.join()


def _work(waiting: SimpleQueue[Job], done: SimpleQueue[Record], stop: threading.Event) -> None:
    """Do jobs until there are none, or until the batch is stopped."""
    try:
        while not stop.is_set():
            job = waiting.get_nowait()
            done.put(_record(job, stop))
    except (Empty, Stopped):
        return
    finally:
        end_process()


def _record(job: Job, stop: threading.Event) -> Record:
    """Do a job. What goes wrong outside its isolated process is a record, too; raises Stopped."""
    try:
        return do_job(job, stop)
    except Stopped:
        raise
    except Exception as problem:
        words = " ".join(str(problem).split()) or type(problem).__name__
        return kept_failure(job, "crashed", f"It was given up: {words}")
