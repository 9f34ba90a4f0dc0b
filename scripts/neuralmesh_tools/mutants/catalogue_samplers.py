# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants of the samplers."""

from __future__ import annotations

from neuralmesh_tools.mutants.mutant import Mutant

SAMPLERS: tuple[Mutant, ...] = (
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
        "if (!lieOnSurfaces(alone))",
        "if (true)",
        ("OutlierFilter.takes_a_sparse_half_for_a_surface",),
    ),
    Mutant(
        "small-groups-are-parts",
        "a small group of points apart is no part of the data",
        "samplers/points/outlier_filter.cpp",
        "found.push_back(sizes[g] <= most);",
        "found.push_back(sizes[g] < 0);",
        ("OutlierFilter.finds_groups_too_small_for_a_part_and_keeps_small_parts",),
    ),
    Mutant(
        "frame-of-all",
        "the frame is that of the points without outliers",
        "samplers/points/point_cloud_sampler.cpp",
        "    setFrame(worldBounds);\n    points_.clear();\n",
        "    points_.clear();\n",
        ("OutlierFilter.leaves_the_frame_to_the_others_however_far_it_is",),
    ),
)
