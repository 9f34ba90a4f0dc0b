#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reconstructs many scans: on all cores of this machine, or on a Dask cluster.

    batch.py scans/ --out meshes --vertices 5000
    batch.py 'scans/**/*.e57' --out meshes --set surfacefit=false --format obj
    batch.py --list scans.txt --out meshes --mlx clean_and_reconstruct.mlx
    batch.py scans/ --out meshes --scheduler tcp://HOST:8786

Each scan runs in a process of its own: one that crashes, hangs or wants too much memory is a
line in DIR/report.csv and report.json, and the others go on. The same command again does only
what is missing, failed or changed: by the input's SHA-256, the parameters, and the versions of
PyMeshLab and plugins. Ctrl-C stops; the same command goes on.

Exit codes: 0 every item has its output, 1 some have failed, 2 nothing was run (usage, an unknown
filter or parameter, another batch in the folder), 130 stopped by Ctrl-C or SIGTERM.
"""

import sys

from neuralmesh_tools.batching.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
