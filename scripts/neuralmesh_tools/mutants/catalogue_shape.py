# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants of the shape of the data."""

from __future__ import annotations

from neuralmesh_tools.mutants.mutant import Mutant

_SHAPE = "core/shape/coarse_shape.cpp"
_WINDING = "core/shape/winding_field.cpp"
_READING = "core/shape/shape_reading.cpp"
_FLOOD = "core/shape/outside_flood.cpp"
_OPENING = "core/shape/membrane_opening.cpp"
_DECIMATION = "core/shape/quadric_decimation.cpp"

SHAPE: tuple[Mutant, ...] = (
    Mutant(
        "plates-are-sheets",
        "a plate with points on both sides is no open sheet",
        "core/shape/coarse_shape.cpp",
        "!haveTwoSides(index_, sidesInCells / resolution())",
        "true",
        ("CoarseShape.of_a_thin_plate_is_no_sheet",),
    ),
    Mutant(
        "sides-of-a-plane",
        "sides are told from the heights above a quadric",
        "core/shape/two_sides.cpp",
        "terms.row(i) << 1, x, y, x * x, x * y, y * y;",
        "terms.row(i) << 1, x, y, 0, 0, 0;",
        ("CoarseShape.knows_a_sheet_whose_sides_are_nearer_than_a_cell",),
    ),
    Mutant(
        "rounding-tells-sides",
        "heights next to nothing tell no sides",
        "core/shape/two_sides.cpp",
        "constexpr double leastHeight = 1e-5;",
        "constexpr double leastHeight = -1;",
        ("Closing.a_flat_sheet_has_no_folds",),
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
        "level-of-a-half",
        "the surface is where the field is what it is at the points nearby",
        _SHAPE,
        "std::max(inside[i], leastLevel)",
        "0.5F",
        ("CoarseShape.leaves_out_parts_that_are_of_a_few_stray_points",),
    ),
    Mutant(
        "nothing-held-outside",
        "what is outside for sure is held there",
        _SHAPE,
        "        field_.holdOutside(flood.outside());",
        "",
        ("CoarseShape.has_no_handles_to_stray_points",),
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
        "    if (static_cast<double>(membrane) <= largeDisc * static_cast<double>(sheet))\n"
        "        return;",
        "    static_cast<void>(membrane);",
        ("OutsideFlood.leaves_a_ball_whose_hole_a_small_membrane_closes",),
    ),
    Mutant(
        "sheets-are-solids",
        "points of an open sheet are known by what the flood would double",
        _SHAPE,
        "flood.doubledShare() > shareOfSheet",
        "flood.doubledShare() > 1 + shareOfSheet",
        ("CoarseShape.knows_an_open_sheet",),
    ),
    Mutant(
        "one-level",
        "the shape is read at several levels",
        _READING,
        "    for (const float level : levels)",
        "    for (const float level : {0.0F})",
        ("ShapeReading.takes_the_shape_of_most_levels_not_that_at_the_points",),
    ),
    Mutant(
        "votes-are-enough",
        "a shape is that of two grids",
        _SHAPE,
        "reading.votes >= fewestVotes && reading.surface.hasShapeOf(coarser.surface)",
        "reading.votes >= clearVotes",
        ("CoarseShape.of_an_arm_beside_a_body_has_no_handle",),
    ),
    Mutant(
        "sheets-are-refined",
        "the shape of a sheet is that of the first grid",
        _SHAPE,
        "bool isStable = isSheet_ && reading.votes >= clearVotes;",
        "bool isStable = isSheet_ && reading.votes < 0;",
        ("Closing.a_sheet_among_outliers_is_one_piece_without_folds",),
    ),
    Mutant(
        "all-is-clear",
        "a shape on which levels and grids disagree is told",
        _SHAPE,
        "        shape.isClear = isStable;",
        "        shape.isClear = true;",
        ("CoarseShape.says_where_the_points_leave_it_open",),
    ),
    Mutant(
        "not-the-simplest",
        "where hardly any levels agree, the simplest shape is taken",
        _READING,
        "    if (votes < fewestVotes)",
        "    if (votes < 0 * fewestVotes)",
        ("ShapeReading.takes_the_simplest_shape_where_hardly_any_levels_agree",),
    ),
    Mutant(
        "stray-parts-stay",
        "parts that hold hardly any points are left out",
        "core/shape/shape_reading.h",
        "constexpr double leastPoints = 12;",
        "constexpr double leastPoints = 0;",
        (
            "ShapeReading.leaves_out_parts_that_hold_hardly_any_points",
            "CoarseShape.leaves_out_parts_that_are_of_a_few_stray_points",
        ),
    ),
    Mutant(
        "membranes-stay",
        "membranes are opened",
        _OPENING,
        "            for (const FaceId f : patch)\n                stays_[f] = false;",
        "",
        (
            "MembraneOpening.opens_a_ball_where_it_has_no_points",
            "CoarseShape.has_a_boundary_where_a_gap_is_wider_than_the_hole",
        ),
    ),
    Mutant(
        "small-gaps-open",
        "gaps that are smaller than a hole are closed",
        _OPENING,
        "            if (patchArea < leastArea)\n                continue;\n",
        "            static_cast<void>(leastArea);\n",
        (
            "MembraneOpening.leaves_a_gap_that_is_smaller_than_the_least_area",
            "CoarseShape.has_a_boundary_where_a_gap_is_wider_than_the_hole",
        ),
    ),
    Mutant(
        "pinches-stay",
        "an opening leaves one fan of faces at each vertex",
        _OPENING,
        "    opening.removePinches();",
        "",
        ("MembraneOpening.leaves_one_fan_of_faces_at_each_vertex",),
    ),
    Mutant(
        "faces-turn-over",
        "no face turns over when edges are decimated",
        _DECIMATION,
        "old * now <= leastTurn * old.Norm() * now.Norm() && old.SquaredNorm() > 0",
        "false && old * now <= leastTurn",
        ("QuadricDecimation.stays_near_a_sphere_and_turns_no_face",),
    ),
    Mutant(
        "long-edges-on-flats",
        "decimation spreads vertices evenly where the surface is flat",
        _DECIMATION,
        "constexpr double lengthWeight = 1e-3;",
        "constexpr double lengthWeight = 0;",
        ("QuadricDecimation.spreads_vertices_evenly_where_the_surface_is_flat",),
    ),
    Mutant(
        "boundaries-decimated-in",
        "a boundary keeps its place when edges are decimated",
        _DECIMATION,
        "if (isBoundaryEdge(mesh_, v, end))",
        "if (false && isBoundaryEdge(mesh_, v, end))",
        ("QuadricDecimation.keeps_the_place_of_a_boundary",),
    ),
    Mutant(
        "crumbs-stay",
        "crumbs of an opened membrane go",
        "core/shape/coarse_shape.cpp",
        "        if (areas[of(v)] < least)\n            mesh.removeVertex(v);",
        "        static_cast<void>(least);",
        ("CoarseShape.of_an_open_sheet_among_strays_is_one_piece",),
    ),
    Mutant(
        "crust-of-cells",
        "the crust bridges gaps between sparse points",
        "core/shape/coarse_shape.cpp",
        "constexpr double crustOfSpacings = 1.6;",
        "constexpr double crustOfSpacings = 0;",
        ("CoarseShape.of_a_thin_wall_of_few_points_has_no_holes",),
    ),
)
