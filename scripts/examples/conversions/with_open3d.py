# SPDX-License-Identifier: GPL-3.0-or-later
"""From Open3D and back: a PointCloud in, a TriangleMesh out, written to out/open3d.ply."""

from pathlib import Path

import neuralmesh
import numpy as np
import open3d

torus = open3d.geometry.TriangleMesh.create_torus(torus_radius=2, tube_radius=0.7)
cloud = torus.sample_points_uniformly(20_000)
cloud.paint_uniform_color([0.8, 0.4, 0.1])

result = neuralmesh.reconstruct(
    np.asarray(cloud.points), vertices=1000, colours=np.asarray(cloud.colors)
)

mesh = open3d.geometry.TriangleMesh(
    open3d.utility.Vector3dVector(result.vertices), open3d.utility.Vector3iVector(result.faces)
)
mesh.vertex_colors = open3d.utility.Vector3dVector(result.colours[:, :3] / 255)
mesh.compute_vertex_normals()
print("watertight:", mesh.is_watertight(), "Euler number:", mesh.euler_poincare_characteristic())

out = Path("out")
out.mkdir(exist_ok=True)
open3d.io.write_triangle_mesh(str(out / "open3d.ply"), mesh)
