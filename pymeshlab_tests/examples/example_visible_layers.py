# SPDX-License-Identifier: GPL-3.0-or-later
"""Reconstruct one mesh from aligned scans: several layers, each with its own matrix."""

from pathlib import Path

import numpy as np
import pymeshlab

# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin("build/pymeshlab/libfilter_neuralmesh.so")

samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
ms = pymeshlab.MeshSet()
ms.load_new_mesh(str(samples / "bunny.obj"))
bunny = ms.current_mesh().vertex_matrix()
middle = np.median(bunny[:, 0])
ms.delete_current_mesh()

# Two scans that overlap, each in the coordinates of its scanner, with the matrix that aligns it.
quarter_turn = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])
for half in (bunny[bunny[:, 0] < middle + 0.02], bunny[bunny[:, 0] > middle - 0.02]):
    scan = (half - quarter_turn[:3, 3]) @ quarter_turn[:3, :3]
    ms.add_mesh(pymeshlab.Mesh(scan))
    ms.set_matrix(transformmatrix=quarter_turn, freeze=False)

ms.apply_filter(
    "generate_surface_reconstruction_neural_mesh",
    source="Points of all visible layers",
    targetvertnum=2000,
)
ms.save_current_mesh("scans.ply")
