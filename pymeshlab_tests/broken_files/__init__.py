# SPDX-License-Identifier: GPL-3.0-or-later
"""Broken point files by format, each maker yielding names, contents and refusals."""
