# SPDX-License-Identifier: GPL-3.0-or-later
"""A progress bar for a filter that runs.

PyMeshLab hands no progress to Python, but a verbose MeshSet prints it, so the filter runs in a
process of its own and this one reads along. Killing that process cancels the filter.
"""

import re
import subprocess
import sys
from pathlib import Path

from rich.progress import Progress

root = Path(__file__).resolve().parent.parent.parent

RECONSTRUCT = """
import sys, pymeshlab
plugin, source, target = sys.argv[1:]
pymeshlab.load_plugin(plugin)
ms = pymeshlab.MeshSet(verbose=True)
ms.load_new_mesh(source)
ms.apply_filter("generate_surface_reconstruction_neural_mesh", targetvertnum=5000)
ms.save_current_mesh(target)
"""
SOURCE = (
    "import pathlib, pymeshlab;"
    "print(pathlib.Path(pymeshlab.__file__).parent / 'tests' / 'sample_meshes' / 'bunny.obj')"
)
source = subprocess.check_output([sys.executable, "-c", SOURCE], text=True).strip()
# On Linux and macOS; filter_neuralmesh.dll on Windows.
plugin = str(root / "build/pymeshlab/libfilter_neuralmesh.so")

filtering = subprocess.Popen(
    [sys.executable, "-c", RECONSTRUCT, plugin, source, "bunny_5000.ply"],
    stdout=subprocess.DEVNULL,
    stderr=subprocess.PIPE,
    text=True,
)
assert filtering.stderr is not None
with filtering.stderr as lines, Progress() as progress:
    bar = progress.add_task("starting", total=100)
    for line in lines:
        if found := re.search(r"LOG: 2 (.*?) +\[ (\d+)% \]", line):
            progress.update(bar, description=found[1][:24], completed=int(found[2]))
if filtering.wait() != 0:
    sys.exit("the filter failed")
print("bunny_5000.ply is there")
