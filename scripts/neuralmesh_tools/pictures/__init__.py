# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of the documents: scenes.py runs the filter and draws, command_line.py has options.

screens.py: the picture of MeshLab is one of scripts/test_desktop, that of a report is a browser's.
"""
