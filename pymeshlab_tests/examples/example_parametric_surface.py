# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh a surface that is given as x, y and z of two parameters, evenly, whatever they do."""

import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

ms = pymeshlab.MeshSet()
ms.apply_filter(
    "create_neural_mesh_from_parametric_surface",
    x="2*cos(u)*sin(v)",
    y="sin(u)*sin(v)",
    z="cos(v) + 0.3*cos(2*v)",
    maxu=6.2831853,
    maxv=3.1415927,
    targetvertnum=1000,
)
ms.save_current_mesh("pebble.ply")
