#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what becomes of meshes where a constant of the core or the samplers has another value.

    sweep_constants.py                         half and double of all that is swept
    sweep_constants.py --only fit --seeds 5    a layer, as the document's tables are called
    sweep_constants.py --only sheetDistance --values 0.2,0.6,1.2
    sweep_constants.py --chance                what other seeds change, without any other change
    sweep_constants.py --document              puts the figures into docs/constants.md

Works beside the build in build/release, which it brings up to date first, and leaves the checkout
as it is: a change is compiled from a folder of its own. The shapes have distance functions and
nothing was tuned on them (filter_neuralmesh/bench/measured_shapes.cpp). A line gives, as ratios to
the code as it is: RMS to the surface, both ways (of the shape that changes most, where that is
remarkable) / greatest distance / share of vertices of valence 6 / processor time, and how many more
faces cross each other. RMS and greatest distance are medians of the seeds and geometric means of
the shapes.

Figures of half and double, of 1,500 vertices and three seeds, are kept in
out/constants/figures.json. Exit codes: 0 done, 1 a value did not build or run, 2 usage, or a
constant or a build that is not there.
"""

import sys

from neuralmesh_tools.constants.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
