# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh a point file on disk that is never loaded, binary PLY, LAS or NPY, in an empty document."""

import numpy as np
import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

# Two million points on an ellipsoid, an N by 3 array.
points = np.random.default_rng(1).normal(size=(2_000_000, 3)).astype(np.float32)
points *= [3, 2, 1] / np.linalg.norm(points, axis=1, keepdims=True)
np.save("ellipsoid.npy", points)

ms = pymeshlab.MeshSet()
ms.apply_filter(
    "generate_surface_reconstruction_neural_mesh",
    source="A point file on disk",
    pointfile="ellipsoid.npy",
    targetvertnum=1000,
)
ms.save_current_mesh("ellipsoid.ply")
