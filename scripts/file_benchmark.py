"""Time and memory of the filter on a huge point file, against points in memory."""

from __future__ import annotations

import multiprocessing
import statistics
import tempfile
import threading
import time
from dataclasses import dataclass
from multiprocessing.queues import Queue
from pathlib import Path

import numpy as np
import pymeshlab
from numpy.typing import NDArray

OURS = "generate_surface_reconstruction_neural_mesh"
MEMORY_POINTS = 1_000_000
CHUNK = 1_000_000
BYTES_PER_POINT = 12
SAMPLING_INTERVAL = 0.01  # seconds between two looks at the memory of the process


@dataclass(frozen=True)
class Run:
    """One run in a process of its own."""

    seconds: float
    peak_mib: float  # of anonymous memory: without pages of files, which the system takes back
    vertices: int
    rms_error: float


def sphere_chunk(count: int, seed: int) -> NDArray[np.float32]:
    """Return random points on the unit sphere, shape (count, 3)."""
    points = np.random.default_rng(seed).standard_normal((count, 3), dtype=np.float32)
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def write_sphere(path: Path, count: int) -> None:
    """Write `count` points on the unit sphere as binary PLY, a chunk at a time."""
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\n"
    header += "".join(f"property float {axis}\n" for axis in "xyz") + "end_header\n"
    with path.open("wb") as stream:
        stream.write(header.encode())
        for start in range(0, count, CHUNK):
            stream.write(sphere_chunk(min(CHUNK, count - start), start).tobytes())


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


def _run(plugin: str, path: str | None, vertices: int, results: Queue[Run]) -> None:
    """Run in a process of its own; without a path on points in memory."""
    pymeshlab.load_plugin(plugin)
    document = pymeshlab.MeshSet(verbose=False)
    source: dict[str, object] = {"source": 3, "pointfile": path}
    if path is None:
        document.add_mesh(pymeshlab.Mesh(sphere_chunk(MEMORY_POINTS, 0).astype(np.float64)))
        source = {"source": 0}
    memory = PeakMemory()
    start = time.perf_counter()
    result = document.apply_filter(OURS, targetvertnum=vertices, **source)
    seconds = time.perf_counter() - start
    results.put(Run(seconds, memory.stop(), result["vertices"], result["rms_error"]))


def run_in_process(plugin: Path, path: Path | None, vertices: int) -> Run:
    """Run on a point file, or without one on points in memory; RuntimeError where that fails."""
    context = multiprocessing.get_context("spawn")
    results = context.Queue()
    name = None if path is None else str(path)
    process = context.Process(target=_run, args=(str(plugin), name, vertices, results))
    process.start()
    process.join()
    if process.exitcode != 0:
        raise RuntimeError(f"the run on {name or 'points in memory'} failed (see above)")
    return results.get()


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
        f"{max(ratios):.2f}; asked: at most 1.3)",
        f"peak anonymous memory of the file's run {max(run.peak_mib for run in in_file):.0f} MiB "
        f"(asked: below 400 MB)",
    ]
    return "\n".join(lines)


def _figures(name: str, runs: list[Run]) -> str:
    seconds = statistics.median(run.seconds for run in runs)
    peak = max(run.peak_mib for run in runs)
    return (
        f"{name}: {seconds:.2f} s, peak anonymous memory {peak:.0f} MiB, {runs[0].vertices} "
        f"vertices, RMS error {runs[0].rms_error:.5f}"
    )
