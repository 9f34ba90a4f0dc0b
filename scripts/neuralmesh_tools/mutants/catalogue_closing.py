# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants of boundaries and of closing them."""

from __future__ import annotations

from neuralmesh_tools.mutants.mutant import Mutant

CLOSING: tuple[Mutant, ...] = (
    Mutant(
        "borders-fold",
        "what goes at the border of a sheet leaves the surface as it is, where it can",
        "core/network/growing_network.cpp",
        "isSheet ? bestCollapseOnSurface(mesh_, v) : noVertex",
        "noVertex",
        ("Closing.a_flat_sheet_has_no_folds",),
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
        ("Closing.a_sheet_among_outliers_has_no_folds",),
    ),
    Mutant(
        "count-is-not-settled",
        "the count is exact where boundaries changed in the fit",
        "core/closing.cpp",
        "    settleCount();\n    const std::vector<VertexId> sheets",
        "    const std::vector<VertexId> sheets",
        ("Closing.doubles_a_sheet_to_any_count",),
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
