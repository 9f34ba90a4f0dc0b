# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh from a point file on disk that is never loaded: binary PLY, LAS or NPY.

Run from the project's root: .venv/bin/python pymeshlab_tests/examples/example_point_file.py
"""

import tempfile
from pathlib import Path

import numpy as np
import pymeshlab

pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

with tempfile.TemporaryDirectory() as folder:
    # Two million points on an ellipsoid, an N by 3 array in NumPy's own format.
    points = np.random.default_rng(1).normal(size=(2_000_000, 3)).astype(np.float32)
    points *= [3, 2, 1] / np.linalg.norm(points, axis=1, keepdims=True)
    path = Path(folder) / "ellipsoid.npy"
    np.save(path, points)

    ms = pymeshlab.MeshSet()  # empty: no layer is needed
    result = ms.apply_filter(
        "generate_surface_reconstruction_neural_mesh",
        source="A point file on disk",
        pointfile=str(path),
        targetvertnum=1000,
    )

mesh = ms.current_mesh()
print(f"{mesh.label()}: {mesh.vertex_number()} vertices, RMS error {result['rms_error']:.4f}")

assert mesh.label() == "ellipsoid neural mesh"
assert mesh.vertex_number() == 1000
# Chords of edges of 0.26 lie some 0.005 below a surface of these curvatures.
assert result["rms_error"] < 0.01
