# SPDX-License-Identifier: GPL-3.0-or-later
"""Neural Mesh beside screened Poisson on the bunny's points: vertices, time, distance to them."""

import time
from pathlib import Path

import pymeshlab

root = Path(__file__).resolve().parent.parent.parent
# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin(str(root / "build/pymeshlab/libfilter_neuralmesh.so"))
samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"

for name in ("neural mesh", "screened Poisson"):
    ms = pymeshlab.MeshSet(verbose=False)
    ms.load_new_mesh(str(samples / "bunny.obj"))  # its normals are for Poisson alone
    start = time.perf_counter()
    if name == "neural mesh":
        ms.apply_filter("generate_surface_reconstruction_neural_mesh", targetvertnum=5000)
    else:
        ms.generate_surface_reconstruction_screened_poisson(depth=8, threads=1)
        ms.meshing_decimation_quadric_edge_collapse(targetfacenum=9996)
    seconds = time.perf_counter() - start
    distance = ms.get_hausdorff_distance(sampledmesh=0, targetmesh=ms.current_mesh_id())
    vertices = ms.current_mesh().vertex_number()
    print(f"{name:17} {vertices} vertices, {seconds:.1f} s, RMS distance {distance['RMS']:.6f}")
