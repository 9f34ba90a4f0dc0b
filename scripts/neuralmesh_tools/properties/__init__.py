# SPDX-License-Identifier: GPL-3.0-or-later
"""Random input, and whether what becomes of it keeps every promise; for tests and for the soak."""
