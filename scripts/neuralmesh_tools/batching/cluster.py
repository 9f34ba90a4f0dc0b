# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs through the workers of a Dask scheduler that is there."""

from __future__ import annotations

import logging
import sys
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from pathlib import Path

import cloudpickle
from distributed import Client, Future, Worker, WorkerPlugin, as_completed

from neuralmesh_tools.batching.folder import Record
from neuralmesh_tools.batching.work import Job, do_job, kept_failure, kept_record

# Where workers find this code: the scripts of a checkout, or the packages of an installation.
CODE = str(Path(__file__).resolve().parents[2])
CONNECT_SECONDS = 10


def run_on_cluster(jobs: list[Job], scheduler: str) -> Generator[Record, None, None]:
    """Yield the record of each job as it finishes.

    scheduler: the address of a Dask scheduler. Its workers must see the inputs, the output folder
    and this code under the same paths. Raises OSError if it does not answer. When the caller stops
    early, what has not started is cancelled.
    """
    with _client(scheduler) as client:
        by_key = {f"{job.run}-{number}": job for number, job in enumerate(jobs)}
        futures = [client.submit(do_job, job, key=key, pure=False) for key, job in by_key.items()]
        try:
            completed = as_completed(futures)
            for future in completed:
                job = by_key[future.key]
                if future.status == "finished":
                    record = future.result()
                elif kept := kept_record(job):  # the worker was lost with the result
                    record = kept
                elif future.status in ("lost", "pending"):  # handed out again
                    completed.add(future)
                    continue
                else:
                    record = _failed(job, future)
                yield record
                future.release()
        finally:
            client.cancel(futures)


def _failed(job: Job, future: Future) -> Record:
    """Record a job that Dask gave up on: its workers were lost, or the scheduler was."""
    reason = future.exception() if future.status == "error" else "the scheduler was lost"
    words = f"Dask gave it up: {' '.join(str(reason).split())}"
    return kept_failure(job, "crashed", words)


@contextmanager
def _client(scheduler: str) -> Iterator[Client]:
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    with Client(scheduler, timeout=CONNECT_SECONDS) as client:
        # Sent by value: the other side need not find this module to find the code.
        cloudpickle.register_pickle_by_value(sys.modules[__name__])
        client.run_on_scheduler(_find_code, CODE)
        client.register_plugin(_FindCode(CODE))
        yield client


def _find_code(folder: str) -> None:
    if folder not in sys.path:
        sys.path.insert(0, folder)


class _FindCode(WorkerPlugin):
    """Lets a worker, started by hand or later, import this code."""

    name = "neural-mesh-batch"

    def __init__(self, folder: str) -> None:
        """folder: that holds the code, on the worker's machine too."""
        self.folder = folder

    def setup(self, worker: Worker) -> None:
        """Called by each worker as it joins."""
        if self.folder not in sys.path:
            sys.path.insert(0, self.folder)
