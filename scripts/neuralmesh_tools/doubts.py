# SPDX-License-Identifier: GPL-3.0-or-later
"""What in a reconstruction's own figures says that it is not to be trusted."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

# As in the filter's log: filter_neuralmesh/hosts/common/reconstruction.cpp.
LEAST_COVERAGE = 0.9
MOST_UNSUPPORTED = 0.05


def doubts(figures: Mapping[str, Any]) -> str:
    """Return a sentence or more about what the filter returned; empty where nothing is wrong.

    Figures that another filter does not return are not looked at.
    """
    sentences = []
    if (coverage := figures.get("coverage", 1.0)) < LEAST_COVERAGE:
        sentences.append(f"{1 - coverage:.0%} of the points are not near the mesh.")
    if (unsupported := figures.get("unsupported_area", 0.0)) > MOST_UNSUPPORTED:
        sentences.append(f"{unsupported:.0%} of the mesh lies where there are no points.")
    if crossing := figures.get("self_intersections", 0):
        sentences.append(f"{crossing:,} faces intersect another.")
    if not figures.get("reached_target", True):
        sentences.append("It does not have the number of vertices asked for.")
    return " ".join(sentences)
