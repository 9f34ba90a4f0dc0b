# SPDX-License-Identifier: GPL-3.0-or-later
"""`neuralmesh compare CLOUD... --out DIR`: beside the reconstruction filters of PyMeshLab."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec

from neuralmesh_tools.comparison.arguments import COMMAND, parser_for_clouds

from .exits import say

NEEDED = ("pymeshlab", "scipy", "jinja2", "plotly")
MISSING = 2
DESCRIPTION = """\
Which reconstruction filter for this cloud? Runs them all and writes a report to look at.

    neuralmesh compare scan.laz --out report
    neuralmesh compare a.ply b.xyz --out report --vertices 2000
    neuralmesh compare cloud.e57 --reference true_surface.obj --out report

Neural Mesh, and from PyMeshLab screened Poisson, ball pivoting and others, cut to the same number
of vertices. Writes DIR/report.html (one file, no network needed: the answer, 3D views coloured by
error, charts, a table), results.csv and results.json. Each filter runs in a process of its own: one
that crashes or takes longer than --timeout is a row of the table.

Exit codes: 0 there is an answer for each cloud, 1 there is none for one of them, 2 usage.
"""


def run(arguments: Sequence[str]) -> int:
    """Compare; return the exit code: 2, with a sentence, where a package is missing."""
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        # Help and wrong usage are told without them.
        parser_for_clouds(DESCRIPTION, COMMAND, ()).parse_intermixed_args(arguments)
        say(
            "compare runs the other filters in PyMeshLab and draws a report: it needs "
            f"{', '.join(missing)}: pip install 'neuralmesh[compare]'."
        )
        return MISSING
    from neuralmesh_tools.comparison.command_line import main

    return main(DESCRIPTION, arguments)
