# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants of boundaries and of closing them."""

from __future__ import annotations

from neuralmesh_tools.mutants.mutant import Mutant

CLOSING: tuple[Mutant, ...] = (
    Mutant(
        "borders-reach-beyond",
        "the start is trimmed to the points",
        "core/shape/coarse_shape.cpp",
        "    if (shape.openings > 0)\n",
        "    if (shape.openings < 0)\n",
        ("Borders.of_the_start_are_those_of_the_points",),
    ),
    Mutant(
        "borders-follow-strays",
        "samples far beyond a border are not learned from",
        "core/growth.cpp",
        "constexpr Scalar reachOfBorder = 2;",
        "constexpr Scalar reachOfBorder = 2000;",
        ("Borders.do_not_follow_strays",),
    ),
    Mutant(
        "trimming-tears",
        "trimming a border tears nothing off",
        "core/shape/border_trimming.cpp",
        "return sides == 2 || (sides == 1 && isCornerInside);",
        "return sides > 0;",
        ("BorderTrimming.tears_nothing_off",),
    ),
    Mutant(
        "sheets-get-discs",
        "an open sheet is closed by a second one",
        "core/topology/sheet_doubling.cpp",
        "return spanned[i] > largeDisc * own[i];",
        "return spanned[i] < 0;",
        ("Closing.doubles_a_sheet_to_any_count",),
    ),
    Mutant(
        "chords-stay",
        "an edge across a sheet is flipped on one of its two sides",
        "core/topology/sheet_doubling.cpp",
        "if (!partChords() || !allHaveRoom())",
        "if (!allHaveRoom())",
        ("SheetDoubling.meshes_after_random_operations_have_a_double",),
    ),
    Mutant(
        "chords-flip-in-front",
        "the side of the flip is that on which the edges do not cross",
        "core/topology/sheet_doubling.cpp",
        "const bool inFront = isValley(a, b);",
        "const bool inFront = true;",
        ("SheetDoubling.both_sides_keep_apart_over_ridges_and_valleys",),
    ),
    Mutant(
        "sides-coincide",
        "the two sides of a doubled sheet are parted",
        "core/network/growing_network.cpp",
        "constexpr Scalar thicknessOfSheets = 1e-3;",
        "constexpr Scalar thicknessOfSheets = 0;",
        ("Closing.doubles_a_sheet_to_any_count",),
    ),
    Mutant(
        "folds-stay",
        "folds of a sheet are smoothed before it is doubled",
        "core/closing.cpp",
        "    unfold(network_, sheets);",
        "",
        ("Closing.doubles_a_sheet_to_any_count",),
    ),
    Mutant(
        "count-is-not-settled",
        "the count is exact where boundaries changed in the fit",
        "core/closing.cpp",
        "    settleCount();\n    const std::vector<VertexId> sheets",
        "    const std::vector<VertexId> sheets",
        ("Closing.snapshots_of_a_sheet_are_closed_and_of_their_count",),
    ),
    Mutant(
        "last-vertex-anywhere",
        "the last vertex lies on the boundary, where it counts one",
        "core/closing.cpp",
        "const bool isLast = room == 1 && !sheets_.isEmpty();",
        "const bool isLast = false;",
        ("Closing.adds_no_more_than_there_is_room_for",),
    ),
    Mutant(
        "ragged-rims",
        "a rim that a disc crosses is smoothed",
        "core/fit/intersection_repair.cpp",
        "            if (rim_.isOnRim(v))\n                moveToMiddle(v);",
        "",
        ("Closing.discs_over_a_ragged_border_cross_nothing",),
    ),
    Mutant(
        "boundary-without-neighbours",
        "a boundary vertex is expected between its neighbours",
        "core/fit/boundary_reach.cpp",
        "    pull.pull += across * toCentre * expected;",
        "",
        ("BoundaryReach.believes_points_that_are_drawn_over_and_over_no_more_than_once",),
    ),
    Mutant(
        "repeated-points-are-news",
        "points that are drawn again tell nothing new of a boundary",
        "core/fit/boundary_reach.cpp",
        "independence_ = std::min(1.0, mostInformation / sweeps_);",
        "static_cast<void>(mostInformation);",
        ("BoundaryReach.believes_points_that_are_drawn_over_and_over_no_more_than_once",),
    ),
)
