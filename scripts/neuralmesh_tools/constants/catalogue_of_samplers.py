# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of the catalogue that is of target spaces."""

from __future__ import annotations

from neuralmesh_tools.constants.entries import (
    IMPLICIT,
    OUTLIERS,
    PARAMETRIC,
    Entry,
    Key,
    fixed,
    swept,
)

_FILTER = "samplers/points/outlier_filter.cpp"

OF_SAMPLERS: dict[Key, Entry] = {
    **swept(
        _FILTER,
        OUTLIERS,
        [
            ("leastPoints", "250", "1000", "points"),
            ("measuredPoints", "500", "2000", "points"),
            ("neighbours", "4", "16", "neighbours"),
            ("leastRatio", "1.25", "5", "medians"),
            ("strayRatio", "1.2", "3.4", "medians"),
            ("strayHeight", "0.25", "1", "distances"),
            ("deviations", "2", "8", "standard deviations"),
            ("mostOfGroup", "0.00125", "0.005", "share of the points"),
            ("mostOutliers", "0.1", "0.4", "share of the points"),
        ],
    ),
    **swept(
        "samplers/points/sparse_parts.cpp",
        OUTLIERS,
        [
            ("directions", "4", "16", "neighbours"),
            ("mostFlatness", "0.05", "0.2", "share of the variance"),
            ("mostSpacingRatio", "1.25", "5", "distances"),
            ("likeSpacing", "1.25", "2", "spacings", "half and double of what is above 1"),
        ],
    ),
    **swept(
        "samplers/points/outlier_filter.h",
        OUTLIERS,
        [
            ("pilotPoints", "10000", "40000", "points"),
            ("morePilotPoints", "50000", "200000", "points"),
        ],
    ),
    **fixed(_FILTER, [("madToDeviation", "ratio", "1 / Φ⁻¹(3/4) of the normal distribution")]),
    **swept(
        "samplers/surfaces/implicit_sampler.cpp",
        IMPLICIT,
        [
            ("stepOfCube", "0.125", "0.5", "cubes"),
            ("rootTolerance", "5e-8", "2e-7", "cubes"),
            ("pilotSamples", "10000", "40000", "samples"),
            ("pilotLines", "250000", "1000000", "lines"),
        ],
    ),
    **swept(
        "samplers/surfaces/surface_cells.cpp",
        IMPLICIT,
        [
            ("cubes", "32 * 64 * 64", "128 * 64 * 64", "cubes"),
            ("fittings", "5", "20", "rounds"),
            ("worthwhile", "0.25", "0.75", "share of the volume", "at double: half of what stays"),
            ("variation", "1.25", "2", "differences", "half and double of what is above 1"),
        ],
    ),
    **swept(
        "samplers/surfaces/parametric_sampler.cpp",
        PARAMETRIC,
        [
            ("cellsAlong", "64", "256", "cells"),
            ("boundOfLargest", "1.25", "2", "densities", "half and double of what is above 1"),
            ("differenceStep", "5e-6", "2e-5", "share of the range"),
        ],
    ),
    **fixed(
        "samplers/surfaces/parametric_sampler.cpp",
        [
            ("nodesAlong", "nodes", "follows from cellsAlong"),
            ("mostTries", "places", "giving up follows from it, no mesh"),
            ("pilotPlaces", "places", "giving up follows from it, no mesh"),
            ("leastKept", "share of the places", "giving up follows from it, no mesh"),
        ],
    ),
    **fixed(
        "samplers/surfaces/implicit_sampler.cpp",
        [
            ("mostLines", "times the lines", "giving up follows from it, no mesh"),
            ("leastHit", "share of the lines", "giving up follows from it, no mesh"),
            ("linesPerReport", "lines", "no mesh follows from it"),
        ],
    ),
}

OF_FILES: dict[Key, Entry] = {
    **fixed(
        "samplers/files/las_header.cpp",
        [("versionMajor", "bytes", "offset in the header, as LAS 1.4 R15 has it")],
    ),
    **fixed(
        "samplers/files/point_layout.cpp",
        [("longestQuote", "characters", "of a file's header in a sentence about it")],
    ),
    **fixed(
        "samplers/files/point_survey.cpp",
        [
            ("points", "points", "taken at once, so that the compiler's vectors are full"),
            ("lanes", "numbers", "follows from points"),
        ],
    ),
    **fixed(
        "samplers/files/point_file_sampler.cpp",
        [
            ("boundsTolerance", "diagonals", "a header that is not believed costs a pass"),
            ("leastFilled", "share of the diagonal", "a header that is not believed costs a pass"),
            ("pointsPerLook", "points", "no mesh follows from it"),
            ("readsAtOnce", "records", "time follows from it, no mesh"),
            ("mostPointsJudged", "points", "time follows from it: the same points are drawn"),
            ("mostDraws", "draws", "giving up follows from it, no mesh"),
        ],
    ),
    **fixed(
        "samplers/input_checks.cpp",
        [("flatExtent", "diagonals", "rounding of single precision is 6e-8")],
    ),
    **fixed(
        "samplers/points/point_cloud_sampler.cpp",
        [("mostPointsJudged", "points", "time follows from it: the same points are drawn")],
    ),
    **fixed(
        "samplers/points/robust_frame.cpp",
        [("farAway", "units of the frame", "no cloud is as wide: half and double change nothing")],
    ),
}
