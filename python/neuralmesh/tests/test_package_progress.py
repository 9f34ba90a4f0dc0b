# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress, cancelling, Ctrl-C, and other threads meanwhile."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time

import neuralmesh
import numpy as np
import pytest
from numpy.typing import NDArray

Points = NDArray[np.float64]

INTERRUPTED = """
import sys, time
import numpy as np, neuralmesh
points = np.random.default_rng(0).normal(size=(int(sys.argv[1]), 3)).astype(np.float32)
points /= np.linalg.norm(points, axis=1)[:, None]
print("starts", flush=True)
try:
    neuralmesh.reconstruct(points, 50000)
except KeyboardInterrupt:
    print(time.time(), flush=True)
"""


def test_progress_is_told_in_order_on_the_thread_that_calls(bunny: Points) -> None:
    told: list[tuple[float, str, int]] = []
    neuralmesh.reconstruct(
        bunny, 3000, progress=lambda f, text: told.append((f, text, threading.get_ident()))
    )
    fractions = [fraction for fraction, _, _ in told]
    assert fractions == sorted(fractions)
    assert told[-1][:2] == (1.0, "Done")
    assert {thread for _, _, thread in told} == {threading.get_ident()}


def test_false_cancels(bunny: Points) -> None:
    with pytest.raises(neuralmesh.Cancelled):
        neuralmesh.reconstruct(bunny, 20_000, progress=lambda *_: False)


def test_what_progress_raises_comes_out(bunny: Points) -> None:
    def fail(*_: object) -> None:
        raise LookupError("mine")

    with pytest.raises(LookupError, match="mine"):
        neuralmesh.reconstruct(bunny, 20_000, progress=fail)


def test_a_bar_shows_nothing_where_there_is_no_terminal(
    ball: Points, capfd: pytest.CaptureFixture[str]
) -> None:
    neuralmesh.reconstruct(ball, 200, progress=True)
    assert capfd.readouterr() == ("", "")


def test_other_threads_run_meanwhile(bunny: Points) -> None:
    done = threading.Event()
    steps = 0

    def count() -> None:
        nonlocal steps
        while not done.is_set():
            steps += 1
            time.sleep(0.01)

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.perf_counter()
    neuralmesh.reconstruct(bunny, 3000)
    took = time.perf_counter() - begin
    done.set()
    thread.join()
    assert steps > took / 0.01 / 10  # with the GIL held, it would have been one or two


# While the points are read, while the shape is learned, while the network grows.
@pytest.mark.parametrize(("points", "delay"), [(4_000_000, 0.02), (100_000, 0.5), (100_000, 1.5)])
def test_ctrl_c_is_heard_within_a_fifth_of_a_second(points: int, delay: float) -> None:
    with subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, str(points)],
        stdout=subprocess.PIPE,
        text=True,
        # Shells have their background jobs ignore the signal.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "starts\n"
        time.sleep(delay)
        sent = time.time()
        process.send_signal(signal.SIGINT)
        heard = float(process.stdout.readline())
        assert process.wait(timeout=30) == 0  # and the interpreter ends in order
    assert heard - sent < 0.2


def test_two_threads_reconstruct_at_once(ball: Points) -> None:
    expected = neuralmesh.reconstruct(ball, 200).vertices
    found: list[NDArray[np.float64]] = []
    threads = [
        threading.Thread(target=lambda: found.append(neuralmesh.reconstruct(ball, 200).vertices))
        for _ in range(2)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [np.array_equal(vertices, expected) for vertices in found] == [True, True]
