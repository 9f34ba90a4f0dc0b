# SPDX-License-Identifier: GPL-3.0-or-later
"""Switches the core's mechanisms off one at a time, to show that each has a test that notices."""
