# SPDX-License-Identifier: GPL-3.0-or-later
"""The bunny's points and its neural mesh in one window, by Polyscope."""

from pathlib import Path

import pymeshlab

root = Path(__file__).resolve().parent.parent.parent
# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin(str(root / "build/pymeshlab/libfilter_neuralmesh.so"))
samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"

source = pymeshlab.MeshSet(verbose=False)
source.load_new_mesh(str(samples / "bunny.obj"))
ms = pymeshlab.MeshSet(verbose=False)
ms.add_mesh(pymeshlab.Mesh(source.current_mesh().vertex_matrix()), "bunny")
ms.apply_filter("generate_surface_reconstruction_neural_mesh", targetvertnum=2000)

ms.show_polyscope()  # until the window is closed
print("shown:", ", ".join(mesh.label() for mesh in ms))
