# SPDX-License-Identifier: GPL-3.0-or-later
"""Every method on every cloud, each in a process of its own: a crash or a hang is a row."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from neuralmesh_tools.comparison.clouds import Cloud, load_cloud
from neuralmesh_tools.comparison.measures import Measured, error_of, measure
from neuralmesh_tools.comparison.reconstruct import reconstruct_at_counts
from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.isolation import IsolatedProcess, Outcome
from neuralmesh_tools.methods import METHODS, Reconstruction

# Where more is not asked for: the paper's size, but not so many that the points could be copied.
DEFAULT_VERTICES = 5000
POINTS_PER_VERTEX = 4
CHART_FRACTIONS = (1.0, 0.5, 0.25)
LEAST_VERTICES = 16
MEASURE_SECONDS = 600.0


@dataclass(frozen=True)
class Settings:
    """vertices: of each result, 0 for the default; threshold: of the F-score, % of the diagonal."""

    methods: list[str]
    vertices: int
    threshold: float
    timeout: float
    threads: int
    plugin: Path
    surface: tuple[Points, Faces] | None = None


@dataclass(frozen=True)
class Result:
    """One method on one cloud. failure is a sentence, empty if it gave a mesh.

    values: metrics, seconds and peak_megabytes by name. curve: (vertices, RMS error), for the
    chart. face_error (m,): for the colours.
    """

    method: str
    failure: str = ""
    values: dict[str, Any] = field(default_factory=dict)
    curve: list[tuple[int, float]] = field(default_factory=list)
    mesh: Reconstruction | None = None
    face_error: NDArray[np.float32] | None = None
    valence_shares: list[float] = field(default_factory=list)

    @property
    def label(self) -> str:
        """What a table calls the method."""
        return METHODS[self.method].label

    @property
    def name(self) -> str:
        """What a sentence calls the method."""
        return METHODS[self.method].name


@dataclass(frozen=True)
class Comparison:
    """All methods on one cloud, with so many vertices each, or why the cloud cannot be had."""

    name: str
    path: str
    failure: str = ""
    cloud: Cloud | None = None
    vertices: int = 0
    results: list[Result] = field(default_factory=list)


def compare(path: Path, settings: Settings, say: Callable[[str], None]) -> Comparison:
    """Run the methods on a cloud; say is told what happens, a line each."""
    with IsolatedProcess() as measuring, tempfile.TemporaryDirectory() as folder:
        loaded = measuring.call(load_cloud, str(path), timeout=MEASURE_SECONDS)
        if not loaded.ok:
            say(f"{path.stem}: {loaded.failure}")
            return Comparison(path.stem, str(path), loaded.failure)
        cloud: Cloud = loaded.value
        vertices = settings.vertices or default_vertices(len(cloud.points))
        results = []
        for method in settings.methods:
            outcome = _reconstruct(method, cloud, vertices, settings, Path(folder))
            result = _result(method, outcome, cloud, settings, measuring)
            say(f"{path.stem}, {result.label}: {result.failure or _summary(result)}")
            results.append(result)
    return Comparison(path.stem, str(path), "", cloud, vertices, results)


def default_vertices(points: int) -> int:
    """5,000, but at most a quarter of the points."""
    return max(LEAST_VERTICES, min(DEFAULT_VERTICES, points // POINTS_PER_VERTEX))


def _reconstruct(
    method: str, cloud: Cloud, vertices: int, settings: Settings, folder: Path
) -> Outcome:
    counts = [max(LEAST_VERTICES, round(vertices * fraction)) for fraction in CHART_FRACTIONS]
    arguments = (method, cloud, list(dict.fromkeys(counts)), settings.plugin, settings.threads)
    with IsolatedProcess({"OMP_NUM_THREADS": str(settings.threads)}) as process:
        return process.call(
            reconstruct_at_counts, *arguments, timeout=settings.timeout, folder=folder
        )


def _result(
    method: str, outcome: Outcome, cloud: Cloud, settings: Settings, measuring: IsolatedProcess
) -> Result:
    if not outcome.ok:
        return Result(method, outcome.failure)
    meshes: list[Reconstruction] = outcome.value
    full, *smaller = meshes
    threshold = settings.threshold / 100 * cloud.diagonal
    arguments = (full.points, full.faces, cloud, settings.surface, threshold)
    found = measuring.call(measure, *arguments, timeout=MEASURE_SECONDS)
    if not found.ok:
        return Result(method, f"Its mesh could not be measured: {found.failure}")
    measured: Measured = found.value
    values = {
        **measured.values,
        "seconds": full.seconds,
        "peak_megabytes": outcome.peak_bytes / 2**20,
    }
    curve = [(values["vertices"], values["rms"])]
    for mesh in smaller:
        arguments = (mesh.points, mesh.faces, cloud, settings.surface)
        error = measuring.call(error_of, *arguments, timeout=MEASURE_SECONDS)
        if error.ok:
            curve.append((len(np.unique(mesh.faces)), error.value))
    return Result(
        method,
        values=values,
        curve=sorted(curve),
        mesh=full,
        face_error=measured.face_error,
        valence_shares=measured.valence_shares,
    )


def _summary(result: Result) -> str:
    values = result.values
    return f"{values['vertices']} vertices, RMS {values['rms']:.3g}, {values['seconds']:.1f} s"
