# SPDX-License-Identifier: GPL-3.0-or-later
"""From trimesh and back: points and surfaces in, a Trimesh out, written to out/trimesh.glb."""

from pathlib import Path

import neuralmesh
import trimesh

torus = trimesh.creation.torus(major_radius=2, minor_radius=0.7)

# The points of a cloud, or of any mesh's vertices.
cloud = trimesh.PointCloud(torus.sample(20_000))
result = neuralmesh.reconstruct(cloud.vertices, vertices=1000)

# The surface of a mesh: uniform by area, whatever its triangles are.
remeshed = neuralmesh.reconstruct(neuralmesh.Surface(torus.vertices, torus.faces), vertices=1000)

mesh = trimesh.Trimesh(result.vertices, result.faces, process=False)
print("watertight:", mesh.is_watertight, "Euler number:", mesh.euler_number)
print(f"area: {mesh.area:.1f} of {torus.area:.1f}; remeshed: {remeshed.info['genus']} handle")

out = Path("out")
out.mkdir(exist_ok=True)
mesh.export(out / "trimesh.glb")
