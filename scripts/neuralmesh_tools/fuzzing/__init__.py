# SPDX-License-Identifier: GPL-3.0-or-later
"""Fuzzing by libFuzzer: seeds, runs, and what became of them. scripts/fuzz calls it."""
