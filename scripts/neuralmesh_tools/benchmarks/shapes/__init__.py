# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of shapes: whether a cloud that is the surface of no simple body takes much longer.

data.py    the clouds     run.py    a cloud's time and figures     table.py   options and print
"""
