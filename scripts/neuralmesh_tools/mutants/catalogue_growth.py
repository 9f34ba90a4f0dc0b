# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants of growth and of the fit."""

from __future__ import annotations

from neuralmesh_tools.mutants.mutant import Mutant

_NETWORK = "core/network/growing_network.cpp"
_FIT = "core/fit/surface_fit.cpp"

GROWTH: tuple[Mutant, ...] = (
    Mutant(
        "nearest-vertex-wins",
        "the winner of a sample is on the sheet that is nearest to it",
        _NETWORK,
        "isYoung() ? projectOnStar",
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
        "rules_.youngSplitTwiceAsOften && isYoung()",
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
        "starts-settle-as-long",
        "a closed start from the data settles with fewer signals",
        "core/growth.cpp",
        "(isNearSamples ? shareOfSettling : 1)",
        "(isNearSamples ? 1 : 1)",
        ("Growth.from_closed_data_takes_fewer_signals_to_settle_than_to_grow",),
    ),
    Mutant(
        "chance-is-replaced",
        "vertices that are idle by chance stay",
        "core/network/census.cpp",
        "constexpr double timesChance = 1.5;",
        "constexpr double timesChance = -1;",
        ("Growth.does_not_replace_vertices_that_are_idle_by_chance",),
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
        "            {}",
        ("Limbs.a_web_between_legs_goes_and_their_inner_walls_are_back",),
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
        "!isOverlong(mesh, v, ring[i])",
        "true",
        ("Shapes.a_scan_of_one_side_keeps_its_points_on_the_mesh",),
    ),
    Mutant(
        "few-points-are-fitted",
        "as many vertices as points are put on these",
        _FIT,
        "    if (interpolatePoints(network, sampler, random))\n",
        "    if (false && interpolatePoints(network, sampler, random))\n",
        ("FewPoints.as_many_vertices_as_points_are_on_the_points",),
    ),
    Mutant(
        "fits-have-no-bounds",
        "the fit stays near the box of the points",
        "core/fit/few_points.cpp",
        "    const Scalar margin = bulge * bounds.Diag();",
        "    const Scalar margin = 10 * bounds.Diag();",
        ("FewPoints.no_vertex_is_far_outside_the_box_of_the_points",),
    ),
)
