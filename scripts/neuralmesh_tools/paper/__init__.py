# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's table and figures made again.

reported.py  what the paper reports, and our models    runs.py  our runs
pictures.py  a figure                                  page.py  all of it as one page
command_line.py  options
"""
