# SPDX-License-Identifier: GPL-3.0-or-later
"""The real MeshLab for scripts/test_desktop: root.py makes it, run.py runs the tests in it."""
