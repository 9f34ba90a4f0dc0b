# SPDX-License-Identifier: GPL-3.0-or-later
"""A call in a process of its own: whatever it does, the caller gets an outcome and goes on."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import psutil
import pytest

from neuralmesh_tools.isolation import IsolatedProcess, Stopped

MEGABYTE = 2**20


def add(a: int, b: int) -> int:
    return a + b


def fail() -> None:
    raise ValueError("two\nlines")


def crash() -> None:
    ctypes.string_at(0)


def hang_in_c() -> None:
    ctypes.PyDLL(None).pause()  # holds the interpreter's lock, as a PyMeshLab filter does


def compute(seconds: float) -> None:
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def fill_memory() -> None:
    kept = []
    while True:
        kept.append(bytearray(10 * MEGABYTE))
        time.sleep(0.001)  # the limit is watched, not enforced


def use_memory(megabytes: int) -> int:
    return len(bytearray(megabytes * MEGABYTE)) and os.getpid()


def print_everywhere() -> None:
    print("from Python")
    ctypes.CDLL(None).puts(b"from C")
    ctypes.CDLL(None).fflush(None)


def pid_of() -> int:
    return os.getpid()


def test_a_call_returns_its_value_and_the_process_serves_the_next():
    with IsolatedProcess() as process:
        first, second = process.call(pid_of), process.call(pid_of)
        assert first.ok
        assert first.value == second.value != os.getpid()
        assert process.call(add, 2, 3).value == 5


def test_an_exception_is_a_sentence_and_costs_the_process():
    with IsolatedProcess() as process:
        before = process.call(pid_of).value
        outcome = process.call(fail)
        assert (outcome.kind, outcome.failure) == ("raised", "two lines")
        assert process.call(pid_of).value != before


def test_a_crash_names_the_signal():
    with IsolatedProcess() as process:
        outcome = process.call(crash)
        assert (outcome.kind, outcome.failure) == ("crashed", "The process crashed with SIGSEGV.")
        assert process.call(add, 1, 1).value == 2


def test_a_hang_in_c_is_killed_at_its_time_out():
    with IsolatedProcess() as process:
        hung = process.call(pid_of).value
        outcome = process.call(hang_in_c, timeout=0.2)
        assert (outcome.kind, outcome.failure) == (
            "timed out",
            "It timed out: it was not done after 0.2 s.",
        )
        assert not psutil.pid_exists(hung)
        assert process.call(add, 1, 1).value == 2


def test_a_limit_of_computing_is_not_that_of_the_clock():
    sentence = "It timed out: it was not done after computing for 0.3 s."
    with IsolatedProcess() as process:
        assert process.call(time.sleep, 1, cpu_timeout=0.3).ok  # a busy machine makes it wait
        outcome = process.call(compute, 60, cpu_timeout=0.3)
        assert (outcome.kind, outcome.failure) == ("timed out", sentence)
        # What waits and never computes is given up too, after ten times as long.
        outcome = process.call(hang_in_c, cpu_timeout=0.05)
        assert (outcome.kind, outcome.failure) == (
            "timed out",
            "It timed out: it was not done after 0.5 s.",
        )


def test_each_call_has_its_own_limit_of_computing():
    with IsolatedProcess() as process:
        assert all(process.call(compute, 0.4, cpu_timeout=0.8).ok for _ in range(4))


def test_names_of_files_are_utf8_whatever_the_locale_is():
    script = (
        "import sys; sys.path[:0] = sys.argv[1:]\n"
        "from neuralmesh_tools.isolation import IsolatedProcess\n"
        "with IsolatedProcess() as process:\n"
        "    print(process.call('locale:getencoding').value)\n"
    )
    scripts = Path(__file__).resolve().parent.parent / "scripts"
    command = [sys.executable, "-c", script, str(scripts)]
    for name in ("C", "POSIX", "C.UTF-8"):
        environment = {**os.environ, "LC_ALL": name}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        assert done.stdout.strip().lower() == "utf-8"


def test_memory_beyond_the_limit_ends_the_call():
    with IsolatedProcess() as process:
        outcome = process.call(fill_memory, memory_limit=200 * MEGABYTE, timeout=60)
        assert outcome.kind == "out of memory"
        assert outcome.failure == "It needed more than the 200 MB allowed."


def test_peak_memory_is_that_of_the_call_and_not_of_those_before():
    with IsolatedProcess() as process:
        large, small = process.call(use_memory, 300), process.call(use_memory, 1)
        assert large.value == small.value  # the same process
        assert large.peak_bytes > 300 * MEGABYTE > small.peak_bytes


def test_processes_are_replaced_after_a_number_of_calls():
    with IsolatedProcess(recycle_after=2) as process:
        pids = [process.call(pid_of).value for _ in range(5)]
    assert pids[0] == pids[1] != pids[2] == pids[3] != pids[4]


def test_output_of_python_and_c_goes_to_the_log(tmp_path: Path):
    log = tmp_path / "log"
    with IsolatedProcess() as process:
        process.call(print_everywhere, log=log)
        process.call(print_everywhere)
    assert sorted(log.read_text().split("\n")) == ["", "from C", "from Python"]


def test_the_process_dies_with_its_parent():
    script = (
        "import os, sys; sys.path[:0] = sys.argv[1:]\n"
        "from neuralmesh_tools.isolation import IsolatedProcess\n"
        "import test_isolation as calls\n"
        "process = IsolatedProcess()\n"
        "print(process.call(calls.pid_of).value, flush=True)\n"
        "process.call(calls.hang_in_c)\n"
    )
    here = Path(__file__).resolve().parent
    parent = subprocess.Popen(
        [sys.executable, "-c", script, str(here.parent / "scripts"), str(here)],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert parent.stdout is not None
    with parent.stdout:
        child = psutil.Process(int(parent.stdout.readline()))
        parent.kill()
        parent.wait()
    child.wait(timeout=20)  # raises if it lives on


def test_a_call_is_stopped_from_another_thread_and_its_process_is_gone():
    stop = threading.Event()
    with IsolatedProcess() as process:
        assert process.call(add, 1, 2, stop=stop).value == 3
        pid = process.pid
        timer = threading.Timer(0.1, stop.set)
        timer.start()
        with pytest.raises(Stopped):
            process.call(hang_in_c, stop=stop)
        timer.join()
        assert pid is not None
        assert not psutil.pid_exists(pid)
        stop.clear()
        assert process.call(add, 2, 3, stop=stop).value == 5
