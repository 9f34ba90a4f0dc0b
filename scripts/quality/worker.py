"""One row of the table in a process of its own, so that a crash or an endless run is a row too.

python -m quality.worker JOB.npz ROW.json [MESH.ply]
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pymeshlab

from quality.methods import reconstruct
from quality.metrics import measure


def main(job_path: str, row_path: str, mesh_path: str = "") -> None:
    """Run the job, measure its mesh and write the row; an exception's words become the row."""
    with np.load(job_path, allow_pickle=False) as job:
        settings = json.loads(str(job["settings"]))
        points, normals = job["points"], job["normals"]
        reference = (job["reference_points"], job["reference_faces"])
    try:
        result = reconstruct(
            settings["method"],
            points,
            normals,
            settings["vertices"],
            threads=settings["threads"],
            plugin=settings["plugin"],
            options=settings["options"],
        )
        if mesh_path:
            save_mesh(result.points, result.faces, mesh_path)
        row = measure(result.points, result.faces, *reference)
        row["seconds"] = result.seconds
        row["cpu_seconds"] = result.cpu_seconds
        row["returned"] = result.returned
    except Exception as problem:
        row = {"failure": " ".join(str(problem).split()) or type(problem).__name__}
    Path(row_path).write_text(json.dumps(row), encoding="utf-8")


def save_mesh(points: np.ndarray, faces: np.ndarray, path: str) -> None:
    """Write a mesh in the format that the path's ending names."""
    mesh_set = pymeshlab.MeshSet(verbose=False)
    mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=points, face_matrix=faces))
    mesh_set.save_current_mesh(path)


if __name__ == "__main__":
    main(*sys.argv[1:])
