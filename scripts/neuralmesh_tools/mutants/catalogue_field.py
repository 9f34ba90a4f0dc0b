# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants of the field that tells inside from outside, and of the flood."""

from __future__ import annotations

from neuralmesh_tools.mutants.mutant import Mutant

_WINDING = "core/shape/winding_field.cpp"
_FLOOD = "core/shape/outside_flood.cpp"


FIELD: tuple[Mutant, ...] = (
    Mutant(
        "sides-of-a-plane",
        "sides are told from the heights above a quadric",
        "core/shape/two_sides.cpp",
        "terms.row(i) << 1, x, y, x * x, x * y, y * y;",
        "terms.row(i) << 1, x, y, 0, 0, 0;",
        ("TwoSides.of_a_bent_plate_are_found",),
    ),
    Mutant(
        "rounding-tells-sides",
        "heights above a rounded plane have one peak",
        "core/shape/two_sides.cpp",
        "constexpr double mostOfOnePeak = 0.87;",
        "constexpr double mostOfOnePeak = 0.84;",
        ("TwoSides.of_heights_with_one_peak_there_are_none",),
    ),
    Mutant(
        "sides-of-any-distance",
        "sides that no grid tells apart are those of a sheet",
        "core/shape/two_sides.cpp",
        "std::max(leastThickness, thinnestInSpacings * spacing)",
        "thinnestInSpacings * spacing",
        (
            "TwoSides.that_are_too_near_are_none",
            "CoarseShape.of_a_plate_thinner_than_a_cell_is_a_sheet",
        ),
    ),
    Mutant(
        "sides-of-any-spacing",
        "sides that the points do not tell apart are those of a sheet",
        "core/shape/two_sides.cpp",
        "std::max(leastThickness, thinnestInSpacings * spacing)",
        "leastThickness",
        ("TwoSides.that_are_too_near_are_none",),
    ),
    Mutant(
        "normals-lean-nowhere",
        "the first normals have a direction in common",
        _WINDING,
        "normals_.assign(places_.size(), axis * area)",
        "normals_.assign(places_.size(), axis * (0 * area))",
        (
            "WindingField.takes_one_side_of_a_sheet_throughout",
            "CoarseShape.knows_a_sheet_whose_sides_are_nearer_than_a_cell",
        ),
    ),
    Mutant(
        "normals-do-not-turn",
        "normals turn to the gradient of the field",
        _WINDING,
        "    turnNormals();\n}",
        "}",
        ("WindingField.is_1_inside_a_sphere_and_0_outside",),
    ),
    Mutant(
        "normals-turn-all-the-way",
        "normals turn half-way only",
        _WINDING,
        "(Vector(normal).Normalize() + direction).Normalize() * length",
        "direction * length",
        (
            "WindingField.settles_and_does_not_swing_from_round_to_round",
            "WindingField.level_of_points_is_between_the_inside_and_the_outside_of_a_thin_rod",
        ),
    ),
    Mutant(
        "no-descent",
        "the field descends towards 1/2 at the points",
        _WINDING,
        "static_cast<float>(along / squared) : 0",
        "static_cast<float>(0 * along) : 0",
        ("WindingField.is_a_half_at_the_points", "CoarseShape.of_a_sphere_is_the_sphere"),
    ),
    Mutant(
        "areas-of-coarse-cells",
        "normals are measured anew in cells of the finer grid",
        _WINDING,
        "        4 * static_cast<double>(former.size())",
        "        1 * static_cast<double>(former.size())",
        ("WindingField.keeps_what_it_has_learned_on_a_finer_grid",),
    ),
    Mutant(
        "walls-not-felt",
        "coarser grids of the solver feel walls between their planes",
        "core/shape/poisson_multigrid.cpp",
        "            coarse[highest] = 0;",
        "            static_cast<void>(highest);",
        (
            "PoissonMultigrid.converges_beside_a_wall_between_the_planes_of_the_coarser_grid",
            "PoissonMultigrid.converges_around_nodes_that_coarse_grids_do_not_see",
        ),
    ),
    Mutant(
        "sources-at-points-alone",
        "the nodes near points are all that their sources reach",
        _WINDING,
        "cells_, smoothings + reachOfDivergence + margin)",
        "cells_, reachOfDivergence)",
        (
            "WindingField.settles_and_does_not_swing_from_round_to_round",
            "WindingField.keeps_what_it_has_learned_on_a_finer_grid",
        ),
    ),
    Mutant(
        "ends-of-the-outside-far",
        "a fine grid is worked on where the outside ends far from all points",
        _WINDING,
        "    takeInBorders(isOutside);",
        "",
        ("WindingField.is_smooth_beside_an_outside_that_ends_far_from_all_points",),
    ),
    Mutant(
        "pockets-stay-inside",
        "a pocket behind a large membrane is outside",
        _FLOOD,
        "        outside_[i] = 1;",
        "        static_cast<void>(i);",
        ("OutsideFlood.takes_back_a_blob_on_a_thin_sheet",),
    ),
    Mutant(
        "membranes-never-close",
        "a pocket behind a small membrane is inside",
        _FLOOD,
        "    if (!isLarge())\n        return;",
        "",
        ("OutsideFlood.leaves_a_ball_whose_hole_a_small_membrane_closes",),
    ),
    Mutant(
        "inner-walls-stay-inside",
        "a second side that has points costs nothing",
        _FLOOD,
        "        sheet = countExplained(nodes_);",
        "        return;",
        ("OutsideFlood.opens_a_mouth_behind_which_a_second_side_has_points",),
    ),
    Mutant(
        "noise-is-a-second-side",
        "points that noise has taken inside are no second side",
        _FLOOD,
        "constexpr double mostNoise = 0.2;",
        "constexpr double mostNoise = 10;",
        ("OutsideFlood.takes_noise_for_no_second_side",),
    ),
    Mutant(
        "thin-walls-stay-inside",
        "a second side may lie half a cell behind the first",
        _FLOOD,
        "constexpr double deep = 0.5;",
        "constexpr double deep = 1;",
        ("OutsideFlood.opens_a_mouth_whose_second_side_is_less_than_a_cell_behind",),
    ),
    Mutant(
        "dense-points-stay",
        "points of uneven density are thinned before their shape is looked for",
        "core/shape/even_density.cpp",
        "    if (!spacings.isUneven())",
        "    if (true)",
        ("EvenDensity.thins_the_dense_end_to_the_sparse_one",),
    ),
    Mutant(
        "spans-without-margin",
        "nodes are relaxed beyond those that sources reach",
        _WINDING,
        "reachOfDivergence + margin",
        "reachOfDivergence + 0 * margin",
        ("CoarseShape.of_both_sides_of_a_plate_has_no_holes",),
    ),
    Mutant(
        "inner-sides-keep-their-normals",
        "normals of a wall's inner side turn before the grid that parts it",
        "core/shape/winding_field.cpp",
        "if (isInner[i] != 0)",
        "if (false)",
        ("CoarseShape.parts_the_sides_of_thin_walls",),
    ),
    Mutant(
        "gaps-are-walls",
        "two walls with a gap between them keep their normals",
        "core/shape/two_sides.cpp",
        "return agreement > 0;",
        "return true;",
        ("InnerSides.of_walls_with_a_gap_between_them_there_are_none",),
    ),
)
