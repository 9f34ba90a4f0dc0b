# SPDX-License-Identifier: GPL-3.0-or-later
"""From PyVista and back: a PolyData in, a PolyData out, written to out/pyvista.vtp."""

from pathlib import Path

import neuralmesh
import pyvista

cloud = pyvista.ParametricTorus(ringradius=2, crosssectionradius=0.7).clean()
cloud["height"] = cloud.points[:, 2]

result = neuralmesh.reconstruct(cloud.points, vertices=1000, quality=cloud["height"])

mesh = pyvista.PolyData.from_regular_faces(result.vertices, result.faces)
mesh["height"] = result.quality
print("open edges:", mesh.n_open_edges, "points:", mesh.n_points, "manifold:", mesh.is_manifold)

out = Path("out")
out.mkdir(exist_ok=True)
mesh.save(out / "pyvista.vtp")
