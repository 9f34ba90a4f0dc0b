#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the paper's Table 1 and figures 1, 6, 9, 10 and 11 again, as one HTML page.

    reproduce_paper.py --out out/paper              all of it: about a minute of computing
    reproduce_paper.py --out out/paper --scale 0.1  a quick look, at a tenth of the vertices

Writes paper.html, which holds all pictures, and each picture as a PNG beside it; prints the
table. Models are fetched as by datasets.py. Exit codes: 0 done, 1 the plugin is missing, the filter
failed, or a model could not be had and is left out, 2 usage.
"""

import sys

from neuralmesh_tools.paper.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
