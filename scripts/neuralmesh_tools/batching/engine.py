# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs through Dask distributed: worker processes on this machine, or a scheduler that is there."""

from __future__ import annotations

import logging
import signal
import sys
import tempfile
from collections.abc import Generator, Iterator
from contextlib import contextmanager

import cloudpickle
import dask
from distributed import Client, Future, LocalCluster, Worker, WorkerPlugin, as_completed

from neuralmesh_tools.batching.folder import Record
from neuralmesh_tools.batching.work import Job, do_job, kept_failure, kept_record
from neuralmesh_tools.project import SCRIPTS

# An item whose worker is lost is handed to another one, this often; then the item is to blame.
LOST_WORKERS_ALLOWED = 3
CONNECT_SECONDS = 10


def run_jobs(jobs: list[Job], *, workers: int, scheduler: str) -> Generator[Record, None, None]:
    """Yield the record of each job as it finishes.

    workers: processes on this machine, one item each at a time; not used if scheduler, the address
    of a Dask scheduler, is given. Its workers must see the inputs, the output folder and this
    project under the same paths. Raises OSError if the scheduler does not answer. When the caller
    stops early, what has not started is cancelled.
    """
    with _client(workers, scheduler) as client:
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
def _client(workers: int, scheduler: str) -> Iterator[Client]:
    if scheduler:
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        with Client(scheduler, timeout=CONNECT_SECONDS) as client:
            # Sent by value: the other side need not find this module to find the project.
            cloudpickle.register_pickle_by_value(sys.modules[__name__])
            client.run_on_scheduler(_find_project, str(SCRIPTS))
            client.register_plugin(_FindProject(str(SCRIPTS)))
            yield client
        return
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": LOST_WORKERS_ALLOWED}),
        tempfile.TemporaryDirectory(prefix="batch-") as scratch,
        _local_cluster(workers, scratch) as cluster,
        Client(cluster) as client,
    ):
        yield client


def _local_cluster(workers: int, scratch: str) -> LocalCluster:
    """Start worker processes, on the loopback only, that leave Ctrl-C to this process."""
    handler = signal.signal(signal.SIGINT, signal.SIG_IGN)  # which the workers inherit
    try:
        return LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            host="127.0.0.1",
            dashboard_address="127.0.0.1:0",  # the default is a fixed port
            memory_limit=None,  # items run in processes of their own, with a limit of their own
            silence_logs=logging.CRITICAL,
            local_directory=scratch,
        )
    finally:
        signal.signal(signal.SIGINT, handler)


def _find_project(scripts: str) -> None:
    if scripts not in sys.path:
        sys.path.insert(0, scripts)


class _FindProject(WorkerPlugin):
    """Lets a worker, started by hand or later, import this project."""

    name = "neural-mesh-batch"

    def __init__(self, scripts: str) -> None:
        """scripts: the project's folder of that name, on the worker's machine too."""
        self.scripts = scripts

    def setup(self, worker: Worker) -> None:
        """Called by each worker as it joins."""
        if self.scripts not in sys.path:
            sys.path.insert(0, self.scripts)
