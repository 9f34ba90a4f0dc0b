# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of strays: whether a few points far off change the mesh of a cloud.

data.py  clouds, their surfaces, and strays     run.py    one run: a mesh, its RMS and its log
table.py options, and all of it in order
"""
