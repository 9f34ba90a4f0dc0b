# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls in a process of their own: a crash, a hang or a flood of memory costs the call, no more.

The process is spawned, not forked, and kept for the calls that follow, because importing PyMeshLab
takes longer than many a reconstruction. It is replaced after every call that did not return (an
exception inside PyMeshLab leaves the C++ standard output redirected) and after a number of calls
(PyMeshLab leaks). Works inside Dask workers, whose daemonic processes multiprocessing refuses
children, and in threads.
"""

from __future__ import annotations

import os
import pkgutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from multiprocessing.connection import Connection, Pipe
from pathlib import Path
from typing import Any

import psutil

from neuralmesh_tools import operating_system

# Memory is looked at this often, in seconds: what is allocated in between goes unnoticed.
WATCH_INTERVAL = 0.02
# Seconds that a busy machine may take to start Python and to import what the call needs.
START_TIMEOUT = 120.0
# A call that waits instead of computing is given up after so many times its limit, by the clock.
WAITING_FACTOR = 10.0
# How the process starts: it finds this package, and nothing in the folder that it starts in.
START = (
    "import sys; sys.path[:] = [sys.argv[1], *filter(None, sys.path)]; "
    "from neuralmesh_tools.isolation import main; main(sys.argv[2])"
)
PACKAGES = Path(__file__).resolve().parent.parent


class Stopped(RuntimeError):
    """The caller stopped a call before its end."""


@dataclass(frozen=True)
class Outcome:
    """What became of a call. kind: returned, raised, crashed, timed out or out of memory.

    failure is a sentence for the user, empty if the call returned. seconds are those of the wall
    clock; peak_bytes is the largest resident size of the process during the call, PyMeshLab
    itself included.
    """

    kind: str
    value: Any
    failure: str
    seconds: float
    peak_bytes: int

    @property
    def ok(self) -> bool:
        """Whether the call returned."""
        return self.kind == "returned"


class IsolatedProcess:
    """Runs one call after another in a spawned Python process. Not for several threads at once."""

    def __init__(
        self, environment: Mapping[str, str] | None = None, *, recycle_after: int = 20
    ) -> None:
        """Start nothing yet; environment is added to the process's own, from the next start on."""
        self._environment = dict(environment or {})
        self._recycle_after = recycle_after
        self._process: subprocess.Popen[bytes] | None = None
        self._pipe: Connection | None = None
        self._calls = 0

    def __enter__(self) -> IsolatedProcess:
        """Return itself; the process ends with the block."""
        return self

    def __exit__(self, *_: object) -> None:
        """End the process."""
        self.close()

    @property
    def pid(self) -> int | None:
        """The process's id, None while there is none."""
        return self._process.pid if self._process else None

    def call(
        self,
        function: Callable[..., Any] | str,
        *arguments: Any,
        timeout: float = float("inf"),
        cpu_timeout: float = float("inf"),
        memory_limit: int = 0,
        log: Path | None = None,
        folder: Path | None = None,
        stop: threading.Event | None = None,
    ) -> Outcome:
        """Call a module's function with arguments that can be pickled.

        A function that is named, as "package.module:function", is imported in the process only.
        timeout in seconds of the wall clock, once imports are done; cpu_timeout in seconds that it
        computes, all threads together, which a busy machine does not change (and ten times as many
        of the wall clock, for a call that hangs); memory_limit in bytes of resident size, 0 for
        none, looked at every 20 ms. What the call prints, C++ included, goes to the end of log,
        else nowhere. folder becomes the working directory. When another thread sets stop, the
        process is killed within 20 ms, and Stopped is raised.
        """
        for _ in range(2):
            process, pipe = self._running()
            try:
                pipe.send((function, arguments, str(log or os.devnull), folder and str(folder)))
                break
            except OSError:  # it died while idle, somebody else's doing
                self.close()
        else:
            return Outcome("crashed", None, "The process could not be started.", 0.0, 0)
        self._calls += 1
        timeout = min(timeout, WAITING_FACTOR * cpu_timeout)
        try:
            outcome = self._await(process, pipe, timeout, cpu_timeout, memory_limit, stop)
        except Stopped:
            self.close()
            raise
        if not outcome.ok or self._calls >= self._recycle_after:
            self.close()
        return outcome

    def close(self) -> None:
        """Kill the process, whatever it does. A further call starts another one."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
        if self._pipe is not None:
            self._pipe.close()
        self._process = self._pipe = None

    def _running(self) -> tuple[subprocess.Popen[bytes], Connection]:
        if self._process is None or self._pipe is None:
            self._pipe, theirs = Pipe()
            self._process = operating_system.start_with(
                theirs,
                [sys.executable, "-c", START, str(PACKAGES)],
                {**os.environ, **operating_system.readable_names(), **self._environment},
            )
            self._calls = 0
            self._pipe.send([str(Path(entry).resolve()) for entry in sys.path])
        return self._process, self._pipe

    def _await(
        self,
        process: subprocess.Popen[bytes],
        pipe: Connection,
        timeout: float,
        cpu_timeout: float,
        memory_limit: int,
        stop: threading.Event | None,
    ) -> Outcome:
        start, allowed, peak = time.perf_counter(), START_TIMEOUT, 0
        cpu_allowed, cpu_before = float("inf"), 0.0
        watched = psutil.Process(process.pid)
        while True:
            if stop is not None and stop.is_set():
                raise Stopped("It was stopped.")
            seconds = time.perf_counter() - start
            try:
                if pipe.poll(max(0.0, min(WATCH_INTERVAL, allowed - seconds))):
                    message = pipe.recv()
                    if message is not None:
                        return Outcome(*message)
                    # It has its imports and begins: the clock of the call starts here.
                    start, allowed = time.perf_counter(), timeout
                    cpu_allowed, cpu_before = cpu_timeout, _computed(watched)
                    continue
                peak = max(peak, watched.memory_info().rss)
                computed = _computed(watched) - cpu_before
            except (EOFError, ConnectionError, psutil.NoSuchProcess):
                return Outcome(
                    "crashed", None, operating_system.how_it_ended(process.wait()), seconds, peak
                )
            if memory_limit and peak > memory_limit:
                failure = f"It needed more than the {memory_limit / 2**20:.0f} MB allowed."
                return Outcome("out of memory", None, failure, seconds, peak)
            if computed >= cpu_allowed:
                failure = f"It timed out: it was not done after computing for {cpu_allowed:g} s."
                return Outcome("timed out", None, failure, seconds, peak)
            if seconds >= allowed:
                failure = f"It timed out: it was not done after {allowed:g} s."
                return Outcome("timed out", None, failure, seconds, peak)


def _computed(process: psutil.Process) -> float:
    """The seconds that a process has computed, all its threads together."""
    times = process.cpu_times()
    return float(times.user + times.system)


# --------------------------------------------------------------------------- inside the process


def _serve(pipe: Connection) -> None:
    """Run what comes through the pipe until its other end is gone."""
    sys.path[:] = pipe.recv()
    while True:
        try:
            function, arguments, log, folder = pipe.recv()
        except EOFError:
            return
        if isinstance(function, str):
            function = pkgutil.resolve_name(function)
        if folder:
            os.chdir(folder)
        _print_into(log)
        operating_system.forget_peak()
        pipe.send(None)
        start = time.perf_counter()
        try:
            kind, value, failure = "returned", function(*arguments), ""
        except MemoryError:
            kind, value, failure = "out of memory", None, "There was not enough memory."
        except Exception as problem:
            words = " ".join(str(problem).split())
            kind, value, failure = "raised", None, words or type(problem).__name__
        seconds = time.perf_counter() - start
        sys.stdout.flush()
        sys.stderr.flush()
        pipe.send((kind, value, failure, seconds, operating_system.peak()))


def _print_into(path: str) -> None:
    """Send both standard streams, those of C++ too, to the end of a file, which is no link."""
    file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | operating_system.NO_LINK, 0o644)
    for stream in (1, 2):
        os.dup2(file, stream)
    os.close(file)


def main(pipe: str) -> None:
    """Serve the process that started this one and gave it an end of a pipe."""
    operating_system.die_with_parent()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _serve(operating_system.connection(pipe))
