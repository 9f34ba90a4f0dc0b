# SPDX-License-Identifier: GPL-3.0-or-later
"""What the desktop tests and the checks after them agree on: files, names and numbers."""

from __future__ import annotations

FILTER = "Surface Reconstruction: Neural Mesh"
OLD_NAME = "Neural Mesh Reconstruction"  # for scripts: in no menu

# Where MeshLab looks for plugins of a user, below the home folder.
EXTRA_PLUGINS = ".local/share/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/2025.07"

# Made by neuralmesh_tools/desktop/run.py, in the folder that both sides see.
CLOUD = "bunny.ply"  # 28,088 points
SMALL = "small.ply"
SMALL_POINTS = 600
FEW = "few.ply"
FEW_POINTS = 3  # one too few
EMPTYING_SCRIPT = "emptying.mlx"  # deletes the layer, then starts our filter by its old name
# The filter scripts of scripts/examples, with the vertices that each asks for.
EXAMPLE_SCRIPTS = {"neural_mesh.mlx": 3000, "clean_reconstruct_colour.mlx": 2000}
SINGLE_PLUGIN = "single.so"
DOUBLE_PLUGIN = "double.so"

# Saved from the desktop, read back by PyMeshLab.
TARGET = 1234  # a number that no default gives
SAVED_MESH = "saved.ply"
SAVED_PROJECT = "saved.mlp"
KEPT_CLOUD = "kept.ply"  # what was refused, saved after the refusal
SCREENSHOTS = "screenshots"
