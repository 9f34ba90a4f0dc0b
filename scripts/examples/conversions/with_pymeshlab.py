# SPDX-License-Identifier: GPL-3.0-or-later
"""From PyMeshLab and back, without its plugin: a layer in, a layer out, to out/pymeshlab.ply."""

from pathlib import Path

import neuralmesh
import numpy as np
import pymeshlab

ms = pymeshlab.MeshSet(verbose=False)
ms.create_torus(hradius=2, vradius=0.7, hsubdiv=200, vsubdiv=80)
layer = ms.current_mesh()

# Layers keep a matrix; transformed_vertex_matrix() has applied it.
result = neuralmesh.reconstruct(layer.transformed_vertex_matrix(), vertices=1000)

ms.add_mesh(pymeshlab.Mesh(result.vertices, result.faces), "torus neural mesh")
figures = ms.get_topological_measures()
print("genus:", figures["genus"], "boundary edges:", figures["boundary_edges"])
assert np.array_equal(ms.current_mesh().vertex_matrix(), result.vertices)

out = Path("out")
out.mkdir(exist_ok=True)
ms.save_current_mesh(str(out / "pymeshlab.ply"))
