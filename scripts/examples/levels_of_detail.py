# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of detail of the bunny, each with an exact number of vertices, into out/lod."""

from pathlib import Path

import pymeshlab

FILTER = "generate_surface_reconstruction_neural_mesh"
LEVELS = (100, 400, 1600)

root = Path(__file__).resolve().parent.parent.parent
pymeshlab.load_plugin(str(root / "build/pymeshlab/libfilter_neuralmesh.so"))
samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"

ms = pymeshlab.MeshSet(verbose=False)
ms.load_new_mesh(str(samples / "bunny.obj"))
cloud = ms.current_mesh_id()
out = Path("out/lod")
out.mkdir(parents=True, exist_ok=True)
for vertices in LEVELS:
    ms.set_current_mesh(cloud)  # the layer whose points are reconstructed
    result = ms.apply_filter(FILTER, targetvertnum=vertices)
    path = out / f"bunny_{vertices}.ply"
    ms.save_current_mesh(str(path))
    print(f"{path}: {result['vertices']} vertices, RMS error {result['rms_error']:.5f}")
