# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of the filter on a huge point file, against points in memory."""

from __future__ import annotations

import statistics
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pymeshlab

from neuralmesh_tools.generated_clouds import sphere, write_ply_in_chunks
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.layers import document_of, load_plugin
from neuralmesh_tools.project import RECONSTRUCT

MEMORY_POINTS = 1_000_000
CHUNK = 1_000_000
BYTES_PER_POINT = 12
SAMPLING_INTERVAL = 0.01  # seconds between two looks at the memory of the process
FROM_FILE = 3  # the filter's source


@dataclass(frozen=True)
class Run:
    """One run in a process of its own."""

    seconds: float
    peak_mib: float  # of anonymous memory: without pages of files, which the system takes back
    vertices: int
    rms_error: float


class PeakMemory:
    """Watches the anonymous memory of this process (Linux: RssAnon) until it is stopped."""

    def __init__(self) -> None:
        """Start to watch, in a thread of its own."""
        self._stop = threading.Event()
        self._peak = 0
        self._thread = threading.Thread(target=self._watch)
        self._thread.start()

    def _watch(self) -> None:
        while not self._stop.wait(SAMPLING_INTERVAL):
            for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
                if line.startswith("RssAnon:"):
                    self._peak = max(self._peak, int(line.split()[1]))

    def stop(self) -> float:
        """Return the most there was, in MiB."""
        self._stop.set()
        self._thread.join()
        return self._peak / 1024


def write_sphere(path: Path, count: int) -> None:
    """Write `count` points on the unit sphere as binary PLY, a chunk at a time."""
    starts = range(0, count, CHUNK)
    chunks = (sphere(min(CHUNK, count - start), start) for start in starts)
    write_ply_in_chunks(path, count, chunks)


def run_in_process(plugin: Path, path: Path | None, vertices: int) -> Run:
    """Run on a point file, or without one on points in memory; RuntimeError where that fails."""
    with IsolatedProcess() as process:
        outcome = process.call(_run, plugin, path, vertices)
    if not outcome.ok:
        where = path or "points in memory"
        raise RuntimeError(f"the run on {where} failed: {outcome.failure}")
    run: Run = outcome.value
    return run


def _run(plugin: Path, path: Path | None, vertices: int) -> Run:
    load_plugin(plugin)
    if path is None:
        document = document_of(sphere(MEMORY_POINTS, 0).astype(np.float64))
        source: dict[str, object] = {}
    else:
        document = pymeshlab.MeshSet(verbose=False)
        source = {"source": FROM_FILE, "pointfile": str(path)}
    memory = PeakMemory()
    start = time.perf_counter()
    result = document.apply_filter(RECONSTRUCT, targetvertnum=vertices, **source)
    seconds = time.perf_counter() - start
    return Run(seconds, memory.stop(), result["vertices"], result["rms_error"])


def compare_file(plugin: Path, points: int, vertices: int, runs: int) -> str:
    """Run both in turns, each in a process of its own; return the figures as text.

    The file, of `points` points, lies in the system's temporary folder and is not kept; it is warm
    (in the page cache) as far as memory allows. Raises OSError where there is no room for it.
    """
    in_memory: list[Run] = []
    in_file: list[Run] = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sphere.ply"
        write_sphere(path, points)
        for _ in range(runs):
            in_memory.append(run_in_process(plugin, None, vertices))
            in_file.append(run_in_process(plugin, path, vertices))
    ratios = [
        file.seconds / memory.seconds for file, memory in zip(in_file, in_memory, strict=True)
    ]
    lines = [
        _figures(f"{MEMORY_POINTS:,} points in memory", in_memory),
        _figures(f"{points:,} points in a file ({points * BYTES_PER_POINT / 1e9:.1f} GB)", in_file),
        f"time ratio {statistics.median(ratios):.2f} (median of {runs}, {min(ratios):.2f} to "
        f"{max(ratios):.2f}; bound 1.3)",
        f"peak anonymous memory of the file's run {max(run.peak_mib for run in in_file):.0f} MiB "
        f"(bound 400 MB)",
    ]
    return "\n".join(lines)


def _figures(name: str, runs: list[Run]) -> str:
    seconds = statistics.median(run.seconds for run in runs)
    peak = max(run.peak_mib for run in runs)
    return (
        f"{name}: {seconds:.2f} s, peak anonymous memory {peak:.0f} MiB, {runs[0].vertices} "
        f"vertices, RMS error {runs[0].rms_error:.5f}"
    )
