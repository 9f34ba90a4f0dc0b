# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh the zeros of a function of x, y and z, in a document that holds nothing yet."""

import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

ms = pymeshlab.MeshSet()
ms.apply_filter(
    "create_neural_mesh_from_implicit_surface",
    expr="x*x + y*y + 2*z*z - 0.5",
    targetvertnum=1000,
)
ms.save_current_mesh("ellipsoid.ply")
