# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture without a screen: the bunny as a neural mesh, drawn by PyVista into bunny_1000.png."""

import os
from pathlib import Path

import pymeshlab

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # no X server needed
import pyvista

root = Path(__file__).resolve().parent.parent.parent
# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin(str(root / "build/pymeshlab/libfilter_neuralmesh.so"))
samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"

ms = pymeshlab.MeshSet(verbose=False)
ms.load_new_mesh(str(samples / "bunny.obj"))
ms.apply_filter("generate_surface_reconstruction_neural_mesh", targetvertnum=1000)
mesh = ms.current_mesh()

plotter = pyvista.Plotter(off_screen=True, window_size=[800, 800])
surface = pyvista.PolyData.from_regular_faces(mesh.vertex_matrix(), mesh.face_matrix())
plotter.add_mesh(surface, color="#fbf0dc", show_edges=True)
plotter.view_xy()
plotter.screenshot("bunny_1000.png")
plotter.close()
print("bunny_1000.png is there")
