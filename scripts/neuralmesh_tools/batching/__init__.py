# SPDX-License-Identifier: GPL-3.0-or-later
"""Many scans reconstructed alike: on this machine, or on a Dask cluster.

inputs.py   which scans                                    recipe.py   what is done to each
names.py    what their outputs are called                  left_out.py what folders leave out
work.py     the task of a worker: one scan, isolated       engine.py   workers on this machine
folder.py   the output folder: lock, records, moves        cluster.py  workers of a Dask scheduler
run.py      all of it, in order                            report.py   report.json and .csv
options.py  what any batch's command line has              per_cent.py errors beside the diagonal

scripts/batch.py reconstructs in PyMeshLab: preflight.py (filters and parameters, before anything
runs), reconstruct.py (one scan), command_line.py. `neuralmesh batch`, of the package, does without.
"""
