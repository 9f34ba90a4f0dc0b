"""The quality table: what each method's surface is worth, against the surface it came from.

models.py    which models, and why each is there       inputs.py   points, noise and outliers
methods.py   ours and its peers, at one vertex count   metrics.py  distances, topology, shape
worker.py    one row in a process of its own           run.py      all rows, peers' from a cache
report.py    the table                                 bars.py     what was asked, what was measured
"""
