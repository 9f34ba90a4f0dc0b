# SPDX-License-Identifier: GPL-3.0-or-later
"""What is switched off, where in the source, and which test is to notice.

A mechanism that is worth its lines has a mutant here. The text of a mutant stands exactly once in
its file: a refactoring that moves it moves it here too (pymeshlab_tests/test_mutants.py).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from neuralmesh_tools.changed_build import changed_text

FOLDER = "filter_neuralmesh"


@dataclass(frozen=True)
class Mutant:
    """One change of one source file, and the C++ tests that fail with it."""

    name: str
    switches_off: str
    """A clause: what the core no longer does."""
    file: str
    """Below filter_neuralmesh."""
    text: str
    """Stands exactly once in the file."""
    replacement: str
    tests: tuple[str, ...]
    """Names as GoogleTest has them; each of them fails."""

    @property
    def path(self) -> str:
        """The file, from the root of the project."""
        return f"{FOLDER}/{self.file}"

    def applied(self, root: Path) -> str:
        """Return the text of the file with the change made.

        Raises Stale if the file is not there or does not hold the text exactly once.
        """
        return changed_text(root, self.path, self.text, self.replacement, self.name)


_NETWORK = "core/network/growing_network.cpp"
_FIT = "core/fit/surface_fit.cpp"
_SHAPE = "core/shape/coarse_shape.cpp"
_WINDING = "core/shape/winding_field.cpp"
_READING = "core/shape/shape_reading.cpp"
_FLOOD = "core/shape/outside_flood.cpp"
_OPENING = "core/shape/membrane_opening.cpp"
_DECIMATION = "core/shape/quadric_decimation.cpp"

MUTANTS: tuple[Mutant, ...] = (
    Mutant(
        "nearest-vertex-wins",
        "the winner of a sample is on the sheet that is nearest to it",
        _NETWORK,
        "isYoung(vertexCount()) ? projectOnStar",
        "true ? projectOnStar",
        (
            "GrowingNetwork.samples_of_a_sheet_are_won_and_projected_on_it_where_another_has_nearer_vertices",
        ),
    ),
    Mutant(
        "signals-count-one",
        "signals count by the distance of their samples",
        _NETWORK,
        "    if (!rules_.signalsCountByDistance)",
        "    if (true)",
        ("Shapes.vertices_go_where_the_surface_bends_most",),
    ),
    Mutant(
        "young-as-old",
        "a young network is split twice as often",
        _NETWORK,
        "rules_.youngSplitTwiceAsOften && isYoung(vertexCount())",
        "false",
        ("Shapes.an_angle_has_no_web_between_its_arms",),
    ),
    Mutant(
        "own-star-only",
        "a sample is projected on other sheets than its winner's",
        _NETWORK,
        "        if (p.squaredDistance < best.squaredDistance)\n            best = p;\n    });",
        "    });",
        (
            "GrowingNetwork.samples_of_a_sheet_are_won_and_projected_on_it_where_another_has_nearer_vertices",
        ),
    ),
    Mutant(
        "islands-stay",
        "what a web encloses is taken out with it",
        "core/topology/unsupported_patches.cpp",
        "if (fillIslands(patch))",
        "if (true)",
        ("Limbs.samples_within_a_web_do_not_hold_it",),
    ),
    Mutant(
        "no-second-try",
        "a web is tried again with a row of faces more",
        "core/topology/web_removal.cpp",
        "constexpr PatchExtent extents[] = {PatchExtent::core, PatchExtent::dilated};",
        "constexpr PatchExtent extents[] = {PatchExtent::core};",
        ("Limbs.a_sample_between_the_feet_does_not_hold_a_web",),
    ),
    Mutant(
        "no-exchange",
        "irregular vertices are exchanged between sweeps of the fit",
        _FIT,
        "if (firstExchange <= number && number < lastExchange)",
        "if (false)",
        ("Growth.makes_even_valences_by_default_whatever_the_size",),
    ),
    Mutant(
        "crossings-stay",
        "faces that cross each other after the fit are taken apart",
        _FIT,
        "    return repairIntersections(network, fit.start());",
        "    return network.findSelfIntersections().faces;",
        ("Shapes.a_thin_plate_does_not_cross_itself",),
    ),
    Mutant(
        "outliers-pull",
        "a sample far off pulls less at the fit",
        _FIT,
        "const Scalar trust = scale > 0 ? ",
        "const Scalar trust = scale > 0 && false ? ",
        ("Shapes.a_sphere_among_outliers_is_as_accurate_as_without",),
    ),
    Mutant(
        "webs-stay",
        "whole webs are taken out",
        _NETWORK,
        "            removeWebs(support);",
        "",
        ("Limbs.a_web_between_legs_goes_and_their_inner_walls_are_back",),
    ),
    Mutant(
        "tears-stay",
        "torn limbs are mended",
        _NETWORK,
        "            mendTears(support);",
        "",
        ("Limbs.a_torn_post_is_whole_again",),
    ),
    Mutant(
        "webs-do-not-shrink",
        "edges that span a void are flipped away",
        _NETWORK,
        "        retractWebs(mesh_, support);",
        "",
        ("Shapes.an_angle_has_no_web_between_its_arms",),
    ),
    Mutant(
        "points-as-dense-as-samples",
        "a sample counts as near from further away where points are few",
        "core/growth.cpp",
        "wideningForFewPoints(sampler_.pointCount(), network_.vertexCount())",
        "1.0",
        ("Shapes.few_points_are_no_reason_to_look_for_webs_everywhere",),
    ),
    Mutant(
        "bridges-miss-samples",
        "a bridge that samples are not near to is not built",
        "core/topology/stump_bridge.cpp",
        "    const double then = best.weight + missed.after;",
        "    const double then = best.weight + 0 * missed.after;",
        ("Limbs.that_few_samples_show_keep_their_tips",),
    ),
    Mutant(
        "fillings-miss-samples",
        "a filling that samples are not near to is not taken for a web",
        "core/topology/web_removal.cpp",
        "if (!(filling.weight + missed.after < ",
        "if (!(filling.weight + 0 * missed.after < ",
        ("Limbs.that_few_samples_show_keep_their_tips",),
    ),
    Mutant(
        "open-scans-have-webs",
        "the sheet that closes an open scan stays",
        _NETWORK,
        "    if (!isOpen_ && isClosed(mesh_)) {",
        "    if (isClosed(mesh_)) {",
        ("Shapes.a_scan_of_one_side_keeps_its_points_on_the_mesh",),
    ),
    Mutant(
        "splits-at-overlong-edges",
        "a vertex is split at its longest edge that does not span a void",
        "core/network/star_splits.cpp",
        "(longestSquared < 0 || !isOverlong(mesh, v, ring[i]))",
        "true",
        ("Shapes.a_scan_of_one_side_keeps_its_points_on_the_mesh",),
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
        "        isSheet_ = isSheet_ || flood.doubledShare() > shareOfSheet;",
        "",
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
        "sheets-get-discs",
        "an open sheet is closed by a second one",
        "core/topology/sheet_doubling.cpp",
        "isOfSheet_[v] = spanned[of(v)] > largeDisc * own[of(v)] ? 1 : 0;",
        "isOfSheet_[v] = 0;",
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
    Mutant(
        "strays-stay",
        "strays near a surface are ignored",
        "samplers/points/outlier_filter.cpp",
        "if (drawn.size() == points.size())",
        "if (false)",
        ("OutlierFilter.finds_strays_that_are_near_enough_to_a_surface_not_to_be_alone",),
    ),
    Mutant(
        "strays-in-the-plane",
        "a stray is off the plane of its neighbours",
        "samplers/points/outlier_filter.cpp",
        "return height > strayHeight * distances[index];",
        "return height >= 0;",
        ("OutlierFilter.keeps_a_clean_cloud_whole",),
    ),
    Mutant(
        "strays-among-strays",
        "the plane is that of neighbours that are no strays",
        "samplers/points/outlier_filter.cpp",
        "if (distances[other] <= strayRatio * usual) // no stray itself",
        "",
        ("OutlierFilter.finds_strays_that_are_near_enough_to_a_surface_not_to_be_alone",),
    ),
    Mutant(
        "repetitions-count",
        "points at one place count as one",
        "samplers/points/outlier_filter.cpp",
        "withoutRepetitions(drawn);",
        "drawn;",
        ("OutlierFilter.counts_points_at_one_place_as_one",),
    ),
    Mutant(
        "company-is-a-surface",
        "outliers in a thin box are no surface",
        "samplers/points/outlier_filter.cpp",
        "constexpr double mostSurfaceVariation = 0.02;",
        "constexpr double mostSurfaceVariation = 0.06;",
        ("OutlierFilter.does_not_take_the_company_of_outliers_in_a_thin_box_for_a_surface",),
    ),
    Mutant(
        "sparse-parts-are-outliers",
        "a sparse part is a surface",
        "samplers/points/outlier_filter.cpp",
        "        lieOnSurfaces(alone))",
        "        false)",
        ("OutlierFilter.takes_a_sparse_half_for_a_surface",),
    ),
    Mutant(
        "frame-of-all",
        "the frame is that of the points without outliers",
        "samplers/points/point_cloud_sampler.cpp",
        "    setFrame(worldBounds);\n    points_.clear();\n",
        "    points_.clear();\n",
        ("OutlierFilter.leaves_the_frame_to_the_others_however_far_it_is",),
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
