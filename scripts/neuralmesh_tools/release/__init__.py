# SPDX-License-Identifier: GPL-3.0-or-later
"""For scripts/release: check.py uses what it made as a user would, elf.py looks into plugins."""
