#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the neural mesh against screened Poisson and ball pivoting, in one run.

    benchmark.py --quality                        the whole table: twelve models, seven conditions
    benchmark.py --quality --models bunny,dino --conditions clean --methods ours
                                                  ours alone; peers' rows come from the cache
    benchmark.py --speed                          time, as a ratio, in one process
    benchmark.py --scale                          time against vertices, points and threads
    benchmark.py --batch                          throughput of scripts/batch.py, two workers to one
    benchmark.py --file                           time and memory on a file of 100,000,000 points
    benchmark.py --topology                       handles, parts and borders, and which are missed
    benchmark.py --topology --rows torus,tube --conditions clean,sparse --seeds 1,2
    benchmark.py --strays                         whether a few points far off change a mesh
    benchmark.py --shapes                         whether a difficult shape takes much longer
    benchmark.py --quality --summary              an overview, and whether the bounds are kept
    benchmark.py --quality --models bunny --ours splitrule=1 --ours smoothingpasses=3
                                                  more rows of ours, with other parameters

Peers' rows do not depend on our code: they are measured once and kept in the cache; --fresh
measures them again. Exit codes: 0 done, 1 a row of ours failed, a bar of --topology, --strays
or --shapes is missed or the plugin is missing, 2 usage.
"""

import sys

from neuralmesh_tools.benchmarks.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
