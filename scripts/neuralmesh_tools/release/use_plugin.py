# SPDX-License-Identifier: GPL-3.0-or-later
"""The built plugin in PyMeshLab: ends with 0 only if it makes what it was asked for.

With a path, loads that plugin; without, the plugin has to be among PyMeshLab's own.
"""

import sys
from pathlib import Path

import pymeshlab

if len(sys.argv) > 1:
    pymeshlab.load_plugin(sys.argv[1])
ms = pymeshlab.MeshSet()
ms.load_new_mesh(str(Path(pymeshlab.__file__).parent / "tests/sample_meshes/bunny.obj"))
result = ms.apply_filter("generate_surface_reconstruction_neural_mesh", targetvertnum=500)
sys.exit(result["vertices"] != 500)
