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

from neuralmesh_tools.comparison.clouds import Cloud, CloudFacts, load_cloud, load_cloud_by_package
from neuralmesh_tools.comparison.measures import Measured, error_of, measure
from neuralmesh_tools.comparison.reconstruct import reconstruct_at_counts
from neuralmesh_tools.doubts import doubts
from neuralmesh_tools.files import shown
from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.isolation import IsolatedProcess, Outcome
from neuralmesh_tools.methods import METHODS, Reconstruction

# Where more is not asked for: the paper's size, but not so many that the points could be copied.
DEFAULT_VERTICES = 5000
POINTS_PER_VERTEX = 4
CHART_FRACTIONS = (1.0, 0.5, 0.25)
LEAST_VERTICES = 16
MEASURE_SECONDS = 600.0
# What is measured in units of the input, and told in per cent of the diagonal.
ERRORS = {
    *("rms", "rms_to_mesh", "rms_to_reference", "chamfer"),
    *("hausdorff_to_mesh", "hausdorff_to_reference"),
}


@dataclass(frozen=True)
class Settings:
    """What is compared, and how.

    vertices: of each result, 0 for the default. threshold: of the F-score, % of the diagonal.
    timeout: seconds of computing. plugin: of PyMeshLab, that runs our method; None: the package
    neuralmesh runs it, and reads the clouds.
    """

    methods: list[str]
    vertices: int
    threshold: float
    timeout: float
    threads: int
    plugin: Path | None
    surface: tuple[Points, Faces] | None = None


@dataclass(frozen=True)
class Result:
    """One method on one cloud. failure is a sentence, empty if it gave a mesh; kind: isolation's.

    doubts: sentences on why it is not to be trusted, empty if it is. values: metrics, seconds and
    peak_megabytes by name. curve: (vertices, RMS error), for the chart. face_error (m,): for the
    colours. Errors are in per cent of the cloud's diagonal.
    """

    method: str
    failure: str = ""
    kind: str = "returned"
    doubts: str = ""
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
    cloud: CloudFacts | None = None
    vertices: int = 0
    results: list[Result] = field(default_factory=list)


def compare(path: Path, name: str, settings: Settings, say: Callable[[str], None]) -> Comparison:
    """Run the methods on a cloud of this name; say is told what happens, a line each."""
    with IsolatedProcess() as measuring, tempfile.TemporaryDirectory() as folder:
        reader = load_cloud if settings.plugin else load_cloud_by_package
        loaded = measuring.call(reader, str(path), timeout=MEASURE_SECONDS)
        if not loaded.ok:
            say(f"{name}: {loaded.failure}")
            return Comparison(name, shown(path), shown(loaded.failure))
        cloud: Cloud = loaded.value
        vertices = settings.vertices or default_vertices(len(cloud.points))
        results = []
        for method in settings.methods:
            outcome = _reconstruct(method, cloud, vertices, settings, Path(folder))
            log = (Path(folder) / f"{method}.log").read_text("utf-8", "replace")
            result = _result(method, outcome, log, cloud, settings, measuring)
            say(f"{name}, {result.label}: {result.failure or _summary(result)}")
            results.append(result)
    return Comparison(name, shown(path), "", cloud.facts(), vertices, results)


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
            reconstruct_at_counts,
            *arguments,
            cpu_timeout=settings.timeout * settings.threads,
            folder=folder,
            log=folder / f"{method}.log",
        )


def _result(
    method: str,
    outcome: Outcome,
    log: str,
    cloud: Cloud,
    settings: Settings,
    measuring: IsolatedProcess,
) -> Result:
    if not outcome.ok:
        return Result(method, shown(outcome.failure), outcome.kind)
    meshes: list[Reconstruction] = outcome.value
    full, *smaller = meshes
    threshold = settings.threshold / 100 * cloud.diagonal
    arguments = (full.points, full.faces, cloud, settings.surface, threshold)
    found = measuring.call(measure, *arguments, timeout=MEASURE_SECONDS)
    if not found.ok:
        failure = f"Its mesh could not be measured: {shown(found.failure)}"
        return Result(method, failure, found.kind)
    measured: Measured = found.value
    per_cent = 100 / cloud.diagonal
    values = {
        **in_per_cent(measured.values, per_cent),
        **told_by_the_filter(full.returned),
        "seconds": full.seconds,
        "peak_megabytes": outcome.peak_bytes / 2**20,
    }
    curve = [(values["vertices"], values["rms_percent"])]
    for mesh in smaller:
        arguments = (mesh.points, mesh.faces, cloud, settings.surface)
        error = measuring.call(error_of, *arguments, timeout=MEASURE_SECONDS)
        if error.ok:
            curve.append((len(np.unique(mesh.faces)), per_cent * error.value))
    return Result(
        method,
        doubts=doubts(as_the_filter_tells(values), log),
        values=values,
        curve=sorted(curve),
        mesh=full,
        face_error=np.float32(per_cent) * measured.face_error,
        valence_shares=measured.valence_shares,
    )


def _summary(result: Result) -> str:
    values = result.values
    figures = (
        f"{values['vertices']:,} vertices, RMS error {values['rms_percent']:.2g} % of the "
        f"diagonal, {values['seconds']:.1f} s"
    )
    return f"{figures}. {result.doubts}" if result.doubts else figures


def in_per_cent(values: dict[str, Any], per_cent: float) -> dict[str, Any]:
    """The same values, with errors times per_cent and named for it."""
    return {
        f"{name}_percent" if name in ERRORS else name: per_cent * value if name in ERRORS else value
        for name, value in values.items()
    }


def told_by_the_filter(returned: dict[str, Any]) -> dict[str, Any]:
    """What our filter itself says of how far points and mesh support each other, in per cent."""
    return {
        f"{name}_percent": 100 * returned[name]
        for name in ("coverage", "unsupported_area")
        if name in returned
    }


def as_the_filter_tells(values: dict[str, Any]) -> dict[str, Any]:
    """The measured figures by the names under which our filter returns its own.

    So one rule says of every method's mesh whether it is to be trusted.
    """
    return {
        "coverage": 1 - values["missed"] / 100,
        "unsupported_area": values["far_from_points"] / 100,
        "self_intersections": values["self_intersecting"],
    }
