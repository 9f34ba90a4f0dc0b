# SPDX-License-Identifier: GPL-3.0-or-later
"""What benchmark.py measures besides the quality table.

speed.py       against screened Poisson, in one process    point_file.py  on a huge point file
batches.py     throughput of batch.py                      command_line.py  options
topology/      handles, parts and borders of many kinds of data, against what is expected
"""
