# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of detail from one run: each snapshot is a layer of its own, the last is the result."""

from pathlib import Path

import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
ms = pymeshlab.MeshSet()
ms.load_new_mesh(str(samples / "bunny.obj"))
ms.apply_filter(
    "generate_surface_reconstruction_neural_mesh",
    targetvertnum=2000,
    snapshots="20,100,500",
)
for layer in list(ms)[1:]:  # all but the cloud, coarsest first
    ms.set_current_mesh(layer.id())
    ms.save_current_mesh(f"bunny_{layer.vertex_number()}.ply")
