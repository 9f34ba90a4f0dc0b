# SPDX-License-Identifier: GPL-3.0-or-later
"""One row of the table, to be measured in an isolated process."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from neuralmesh_tools.layers import document_of, load_plugin
from neuralmesh_tools.methods import Method, Task, cut_down, reconstruct
from neuralmesh_tools.metrics import measure
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

    Raises what PyMeshLab raises.
    """
    method, case = job.method, job.case
    if job.plugin:
        load_plugin(job.plugin)
    normals = case.normals if method.needs_normals else None
    result = reconstruct(method, document_of(case.points, normals=normals), job.task)
    if not method.exact:
        result = cut_down(result, job.task.vertices)
    if job.mesh:
        document_of(result.points, result.faces).save_current_mesh(str(job.mesh))
    measured = measure(result.points, result.faces, case.reference_points, case.reference_faces)
    return {
        **measured,
        "seconds": result.seconds,
        "cpu_seconds": result.cpu_seconds,
        "returned": result.returned,
    }
