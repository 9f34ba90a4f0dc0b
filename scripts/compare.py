#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which reconstruction filter for this cloud? Runs them all and writes a report to look at.

    compare.py scan.ply --out report
    compare.py a.ply b.xyz --out report --vertices 2000
    compare.py cloud.ply --reference true_surface.obj --out report

Neural Mesh, screened Poisson, ball pivoting and PyMeshLab's other reconstruction filters, cut to
the same number of vertices. Writes DIR/report.html (one file, no network needed: the answer, 3D
views coloured by error, charts, a table), results.csv and results.json. Each filter runs in a
process of its own: one that crashes or takes longer than --timeout is a row of the table.

Exit codes: 0 there is an answer for each cloud, 1 there is none for one of them, 2 usage.
"""

import sys

from neuralmesh_tools.comparison.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
