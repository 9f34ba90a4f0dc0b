# SPDX-License-Identifier: GPL-3.0-or-later
"""One row of the table, to be measured in an isolated process."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from neuralmesh_tools.layers import document_of, load_plugin
from neuralmesh_tools.methods import Method, Reconstruction, Task, cut_down, reconstruct
from neuralmesh_tools.metrics import distances, measure
from neuralmesh_tools.quality.inputs import Case


@dataclass(frozen=True)
class Job:
    """A method on a case. plugin: to load, for ours. mesh: where the mesh is kept, if it is."""

    method: Method
    case: Case
    task: Task
    plugin: Path | None = None
    mesh: Path | None = None


def measure_row(job: Job) -> dict[str, Any]:
    """Reconstruct and measure; the true normals reach only the methods that need them.

    Of a method that is the best of several settings, the row is that whose errors both ways have
    the least geometric mean, and names the setting. Raises what PyMeshLab raises.
    """
    if job.plugin:
        load_plugin(job.plugin)
    method, result = _best(job)
    if not method.exact:
        result = cut_down(result, job.task.vertices)
    if job.mesh:
        document_of(result.points, result.faces).save_current_mesh(str(job.mesh))
    case = job.case
    measured = measure(result.points, result.faces, case.reference_points, case.reference_faces)
    return {
        **measured,
        "setting": method.label if job.method.settings else None,
        "seconds": result.seconds,
        "cpu_seconds": result.cpu_seconds,
        "returned": result.returned,
    }


def _best(job: Job) -> tuple[Method, Reconstruction]:
    """The method, or that of its settings whose mesh is nearest, and what it gives."""
    if not job.method.settings:
        return job.method, _reconstructed(job, job.method)
    results = [(setting, _reconstructed(job, setting)) for setting in job.method.settings]
    return min(results, key=lambda result: _error(job, result[1]))


def _reconstructed(job: Job, method: Method) -> Reconstruction:
    normals = job.case.normals if method.needs_normals else None
    return reconstruct(method, document_of(job.case.points, normals=normals), job.task)


def _error(job: Job, dense: Reconstruction) -> float:
    """The geometric mean of both errors, squared, where the count is met about."""
    cut = cut_down(dense, job.task.vertices, attempts=0)
    reference = job.case.reference_points, job.case.reference_faces
    found = distances(cut.points, cut.faces, *reference)
    return found["rms_to_mesh"] * found["rms_to_surface"]
