# SPDX-License-Identifier: GPL-3.0-or-later
"""The topology table: whether a mesh has the handles, parts and borders of its data.

data.py    points, and the surfaces they are of     rows.py    which, and what is expected
run.py     one run: a mesh and its figures          judge.py   what is wrong, what a row needs
report.py  the table                                table.py   options, and all of it in order
"""
