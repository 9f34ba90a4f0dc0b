# SPDX-License-Identifier: GPL-3.0-or-later
"""What in a reconstruction's figures and log says that it is not to be trusted."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

# As in the filter's log: filter_neuralmesh/hosts/common/reconstruction.cpp.
LEAST_COVERAGE = 0.9
MOST_UNSUPPORTED = 0.05
# The filter's line in the log, and what it warns of there: the rest of the sentence, without the
# advice after it.
LOG_LINE = "Neural mesh: "
WARNING = re.compile(r"Warning: (.+?\.)(?=\s|$)")
# What the log says in words of its own of the figures that it also returns.
TOLD_BY_FIGURES = ("are not near the mesh", "lies where there are no points", "intersect another")


def doubts(figures: Mapping[str, Any], log: str = "") -> str:
    """Return a sentence or more about what the filter returned; empty where nothing is wrong.

    Figures that another filter does not return are not looked at. log: what the filters printed.
    A filter script returns no figures: then the log alone tells.
    """
    sentences = _of_figures(figures)
    has_figures = "coverage" in figures
    for sentence in warnings_in(log):
        if not (has_figures and any(words in sentence for words in TOLD_BY_FIGURES)):
            sentences.append(sentence)
    return " ".join(sentences)


def warnings_in(log: str) -> list[str]:
    """Return the warnings of our filters in what a document printed, each once."""
    lines = [line.partition(LOG_LINE)[2] for line in log.splitlines() if LOG_LINE in line]
    found = [words for line in lines for words in WARNING.findall(line)]
    return list(dict.fromkeys(words[0].upper() + words[1:] for words in found))


def _of_figures(figures: Mapping[str, Any]) -> list[str]:
    sentences = []
    if (coverage := figures.get("coverage", 1.0)) < LEAST_COVERAGE:
        sentences.append(f"{1 - coverage:.0%} of the points are not near the mesh.")
    if (unsupported := figures.get("unsupported_area", 0.0)) > MOST_UNSUPPORTED:
        sentences.append(f"{unsupported:.0%} of the mesh lies where there are no points.")
    if crossing := figures.get("self_intersections", 0):
        sentences.append(f"{crossing:,} faces intersect another.")
    if not figures.get("reached_target", True):
        sentences.append("It does not have the number of vertices asked for.")
    return sentences
