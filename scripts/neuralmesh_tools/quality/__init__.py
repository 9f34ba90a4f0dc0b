# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality table: what each method's surface is worth, against the surface it came from.

models.py    which models, and why each is there       inputs.py   points, noise and outliers
shapes.py    models that are generated                 row.py      one method on one case
run.py       all rows, peers' from a cache             report.py   the table
bounds.py    what the defaults have to keep to         table.py    options, and all of it in order
"""
