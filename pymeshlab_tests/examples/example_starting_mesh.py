# SPDX-License-Identifier: GPL-3.0-or-later
"""Reconstruct a ring: the network starts from a coarse torus, and its hole stays."""

import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

ms = pymeshlab.MeshSet()
ms.create_torus(hradius=3, vradius=1, hsubdiv=96, vsubdiv=48)
ms.generate_sampling_montecarlo(samplenum=20000)  # the points of a scan
scan = ms.current_mesh_id()
ms.create_torus(hradius=2.8, vradius=0.8, hsubdiv=8, vsubdiv=5)  # roughly in place
start = ms.current_mesh_id()

ms.set_current_mesh(scan)
result = ms.apply_filter(
    "generate_surface_reconstruction_neural_mesh",
    startmesh="A layer",
    startlayer=start,
    targetvertnum=1000,
)
assert result["genus"] == 1
ms.save_current_mesh("ring.ply")
