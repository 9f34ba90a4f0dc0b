# SPDX-License-Identifier: GPL-3.0-or-later
"""Neural Mesh beside the other reconstruction filters of PyMeshLab, on a user's own clouds.

clouds.py    a cloud, its normals and spacing       reconstruct.py  a method at several counts
measures.py  what a result is worth                 run.py       all of it, each call isolated
verdict.py   which one to use, from the figures     figures.py   3D views and charts
page.py      report.html                            tables.py    results.csv and results.json
kept.py      comparisons of earlier runs           command_line.py  options
"""
