# SPDX-License-Identifier: GPL-3.0-or-later
"""Remesh the surface of a mesh that has few, large faces: sampled uniformly by area."""

import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

ms = pymeshlab.MeshSet()
ms.create_dodecahedron()  # 20 corners: their points alone would not carry 1,000 vertices
ms.apply_filter(
    "generate_surface_reconstruction_neural_mesh",
    source="Surface of the current layer",
    targetvertnum=1000,
)
ms.save_current_mesh("dodecahedron.ply")
