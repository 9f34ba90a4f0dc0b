# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of detail of the bunny from one run, each of an exact size, into out/lod."""

from pathlib import Path

import pymeshlab

FILTER = "generate_surface_reconstruction_neural_mesh"
LEVELS = (100, 400, 1600)

root = Path(__file__).resolve().parent.parent.parent
# On Linux and macOS; filter_neuralmesh.dll on Windows.
pymeshlab.load_plugin(str(root / "build/pymeshlab/libfilter_neuralmesh.so"))
samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"

ms = pymeshlab.MeshSet(verbose=False)
ms.load_new_mesh(str(samples / "bunny.obj"))
*coarser, finest = LEVELS
ms.apply_filter(FILTER, targetvertnum=finest, snapshots=",".join(map(str, coarser)))

out = Path("out/lod")
out.mkdir(parents=True, exist_ok=True)
for layer in list(ms)[1:]:  # all but the cloud, coarsest first
    ms.set_current_mesh(layer.id())
    path = out / f"bunny_{layer.vertex_number()}.ply"
    ms.save_current_mesh(str(path))
    print(f"{path}: {layer.vertex_number()} vertices, {layer.face_number()} faces")
