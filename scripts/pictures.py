#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of README.md and docs/algorithm.md from real runs of the filter.

    pictures.py                   all, into docs/pictures/
    pictures.py --out out growth  one of them, somewhere else
    pictures.py --report out/compare/report.html --screen out/desktop/result.png
                                  of screens: compare.py in Chromium, MeshLab by test_desktop

Models are fetched as by datasets.py. Exit codes: 0 done, 1 the plugin or a model could not be had,
2 usage.
"""

import sys

from neuralmesh_tools.pictures.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
