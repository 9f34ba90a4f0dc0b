# SPDX-License-Identifier: GPL-3.0-or-later
"""The installed package neuralmesh: ends with 0 only if arrays, files and its command work."""

import subprocess
import sys
import tempfile
from pathlib import Path

import neuralmesh
import numpy as np

points = np.random.default_rng(0).normal(size=(5000, 3))
points /= np.linalg.norm(points, axis=1)[:, None]
result = neuralmesh.reconstruct(points, vertices=500)
assert result.vertices.shape == (500, 3)
with tempfile.TemporaryDirectory() as folder:
    cloud, mesh = Path(folder) / "cloud.ply", Path(folder) / "mesh.ply"
    neuralmesh.write(cloud, neuralmesh.Mesh(points, np.zeros((0, 3), np.int32)))
    command = [sys.executable, "-m", "neuralmesh", str(cloud), "-n", "500", "-o", str(mesh)]
    subprocess.run(command, check=True)
    assert np.array_equal(neuralmesh.read(mesh).points, result.vertices)
