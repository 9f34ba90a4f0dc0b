# SPDX-License-Identifier: GPL-3.0-or-later
"""Spend vertices where they are wanted: samples in proportion to vertex quality."""

from pathlib import Path

import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
ms = pymeshlab.MeshSet()
ms.load_new_mesh(str(samples / "bunny.obj"))
ms.compute_scalar_by_function_per_vertex(q="y > 0.12 ? 10 : 1")  # the head, ten times as dense
ms.apply_filter(
    "generate_surface_reconstruction_neural_mesh",
    densityfromquality=True,
    targetvertnum=2000,
)
ms.save_current_mesh("dense_head.ply")
