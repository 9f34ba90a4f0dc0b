# SPDX-License-Identifier: GPL-3.0-or-later
"""Many scans through the same filters: on this machine, or on a Dask cluster.

inputs.py   which scans                                       recipe.py   what is done to each
names.py    what their outputs are called                     left_out.py what folders leave out
preflight.py  filters and parameters, before anything runs    reconstruct.py  one scan, isolated
work.py     the Dask task around it                           engine.py   the cluster
folder.py   the output folder: lock, records, moves           report.py   report.json and .csv
run.py      all of it, in order                               command_line.py  options
"""
