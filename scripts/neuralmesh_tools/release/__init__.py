# SPDX-License-Identifier: GPL-3.0-or-later
"""For scripts/release: check.py uses what it made as a user would.

needs.py looks into plugins; use_*.py are programs that check.py and the workflows run where
something was installed.
"""
