# SPDX-License-Identifier: GPL-3.0-or-later
"""Which constants are swept, in what units, on which shapes, and why others are not.

Half and double are of what the unit says. Of the angle, where a constant is a cosine; of what is
lost, where it is what is kept.
"""

from __future__ import annotations

from neuralmesh_tools.constants.catalogue_of_samplers import OF_FILES, OF_SAMPLERS
from neuralmesh_tools.constants.entries import (
    BODIES,
    EDGES,
    LEARNED,
    NOISE,
    OUTLIERS,
    SCANS,
    SPARSE,
    WALLS,
    Entry,
    Key,
    fixed,
    swept,
)
from neuralmesh_tools.constants.source import ATTRIBUTES, PARAMETERS

_NETWORK = "core/network/growing_network.cpp"
_FIT = "core/fit/surface_fit.cpp"
_GROWTH = "core/growth.cpp"
_CENSUS = "core/network/census.cpp"

_LEARNING = {
    **fixed(
        PARAMETERS,
        [
            ("targetVertexCount", "vertices", "the user chooses it"),
            ("maxHoleSize", "diagonals", "the user chooses it"),
        ],
    ),
    **swept(
        PARAMETERS,
        BODIES,
        [
            ("winnerRate", "0.03", "0.12", "share of the way"),
            ("smoothingRate", "0.025", "0.1", "share of the way"),
            ("smoothingPasses", "3", "10", "passes"),
            ("signalsPerSplit", "50", "200", "signals"),
            ("inactivityFactor", "6", "24", "signals a vertex", "by the command in the header"),
            ("counterDecay", "0.99", "0.9975", "share kept", "by the command in the header"),
        ],
    ),
    **swept(
        "core/network/learning_rules.h",
        BODIES,
        [
            ("samplesOfSupport", "6", "24", "samples a vertex"),
        ],
    ),
    **fixed(
        "core/network/learning_rules.h",
        [("samplesOfSupportInPaper", "samples a vertex", "splitrule=1 alone takes it")],
    ),
}

_OF_NETWORK = {
    **swept(
        _NETWORK,
        BODIES,
        [
            ("fewVertices", "25", "100", "vertices"),
            ("youngVertices", "250", "1000", "vertices"),
            ("webVertices", "500", "2000", "vertices"),
            ("countByDistanceFrom", "0.2", "0.8", "share of the target"),
        ],
    ),
    **swept(
        _NETWORK,
        (*SCANS, "hand", "radiator"),
        [
            ("judgedVertices", "400", "1600", "vertices"),
            ("shareOfOpenSurface", "0.1", "0.4", "share of the area"),
        ],
    ),
    **swept(
        "core/network/sample_locator.cpp", WALLS, [("sheetDistance", "0.4", "1.6", "mean edges")]
    ),
    **fixed(
        "core/network/sample_locator.cpp",
        [
            ("farthestClearance", "mean edges", "time follows from it, no mesh"),
            ("rounding", "share", "far above that of double; no mesh follows from it"),
        ],
    ),
    **swept(
        "core/network/batch_learning.cpp",
        LEARNED,
        [("mostSmoothing", "0.25", "1", "share of the Laplacian")],
    ),
    **fixed(
        "core/network/batch_learning.cpp",
        [("manySteps", "steps", "0.94 to its power is 1e-7: no mesh follows from it")],
    ),
    **fixed(
        "core/parallel/workers.h",
        [("mostThreads", "threads", "no mesh follows from it")],
    ),
    **fixed(
        "core/shape/grid_loops.h",
        [("nodesOfChunk", "nodes", "time follows from it, no mesh")],
    ),
    **swept(
        "core/network/signal_activity.cpp",
        BODIES,
        [
            ("errorShare", "0.375", "1", "share of a count", "at double: all of it"),
            ("mostRelative", "2", "8", "means"),
            ("meanWeight", "0.0005", "0.002", "share of the mean"),
        ],
    ),
    **swept(
        "core/network/edge_flips.cpp",
        BODIES,
        [
            ("creaseCosine", "0.940", "0.174", "cosine of 40°"),
            ("foldCosine", "0.906", "-0.174", "cosine of 50°"),
            ("goodAngleCosine", "0.966", "0.5", "cosine of 30°"),
            ("leastAngleGain", "5e-7", "2e-6", "cosine"),
        ],
    ),
    **swept(
        "core/network/regular_collapses.cpp",
        BODIES,
        [
            ("mostTurnCosine", "0.954", "0.342", "cosine of 35°"),
            ("goodAngleCosine", "0.985", "0.766", "cosine of 20°"),
            ("mostHeight", "0.1", "0.4", "lengths of the edge"),
        ],
    ),
    **swept(
        "core/network/boundary_notches.cpp",
        EDGES,
        [
            ("notchCosine", "0.866", "-0.5", "cosine of 60°"),
            ("slitWidth", "0.25", "1", "edges beside it"),
        ],
    ),
    **fixed(
        "core/network/signal_counters.cpp",
        [
            (
                "largestUnit",
                "signals",
                "far from the overflow of double, 1e308; no mesh follows from it",
            )
        ],
    ),
}

_OF_GROWTH = {
    **swept("core/start.cpp", BODIES, [("startingSamples", "500", "2000", "samples")]),
    **swept(
        _GROWTH,
        BODIES,
        [
            ("batchPerVertexOneByOne", "0.25", "1", "signals a vertex"),
            ("consolidationRounds", "5", "20", "rounds"),
        ],
    ),
    **swept(_GROWTH, LEARNED, [("closingBatches", "2", "8", "batches")]),
    **swept(_GROWTH, LEARNED, [("batchPerVertex", "1", "4", "samples a vertex")]),
    **swept(_GROWTH, LEARNED, [("shareOfSettling", "0.125", "0.5", "share of λ")]),
    **swept(_GROWTH, EDGES, [("reachOfBorder", "1", "4", "mean edges")]),
    **swept(_CENSUS, BODIES, [("samplesPerVertex", "5", "20", "samples a vertex")]),
    **swept(
        _CENSUS,
        SPARSE,
        [
            ("fewPointsPerVertex", "2", "8", "points a vertex"),
            ("timesChance", "0.75", "3", "idle vertices by chance"),
        ],
    ),
    **swept(
        "core/network/stagnation.h",
        SPARSE,
        [
            ("leastGain", "0.025", "0.1", "share of the vertices"),
            ("stagnationPeriods", "3", "10", "times μ·n signals"),
        ],
    ),
    **fixed(
        _GROWTH,
        [
            ("shareOfGrowth", "share of the time", "the progress bar follows from it, no mesh"),
            ("signalsPerReport", "signals", "the progress bar follows from it, no mesh"),
        ],
    ),
    **fixed(
        "core/result/measurement.cpp",
        [
            (
                "samplesPerVertex",
                "samples a vertex",
                "figures that are told follow from it, no mesh",
            ),
            ("mostInHaste", "samples", "figures that are told follow from it, no mesh"),
        ],
    ),
    **fixed(
        "core/result/convergence.cpp",
        [
            (
                "samplesPerVertex",
                "samples a vertex",
                "figures that are told follow from it, no mesh",
            ),
            ("firstDoubling", "vertices", "figures that are told follow from it, no mesh"),
        ],
    ),
}

_OF_FIT = {
    **swept(
        _FIT,
        BODIES,
        [
            ("samplesPerVertex", "4", "16", "samples a vertex"),
            (
                "steps",
                "{0.45, 0.45, 0.45, 0.4, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15}",
                "{1, 1, 1, 1, 1, 1, 1, 1, 0.8, 0.6}",
                "share of the step",
                "at double: whole steps at the most",
            ),
            ("tangentialDeviation", "0.125", "0.5", "mean edges"),
            ("goodCosine", "0.917", "0.695", "cosine of 31°", "half and double as far from 16°"),
            ("sliverCosine", "0.990", "0.914", "cosine of 16°", "at double: 24°"),
            ("leastTangentialShare", "0.025", "0.1", "share of the deviation"),
            ("leastBending", "0.25", "1", "share of the variance"),
            ("firstExchange", "0", "2", "sweeps"),
            ("lastExchange", "4", "9", "sweeps", "at double: to the last but one"),
            ("longestMove", "0.15", "0.6", "shortest edges"),
        ],
    ),
    **swept(
        _FIT,
        NOISE,
        [
            ("scatterOfRelief", "0.06", "0.24", "mean edges"),
            ("scatterOfNoise", "0.135", "0.54", "mean edges"),
            ("noiseInBending", "3", "12", "variances"),
            ("leastBendingInNoise", "0.1", "0.4", "share of the variance"),
            ("mostBendingInNoise", "2.5", "10", "medians"),
            ("sweepsAfterGrowth", "1", "6", "sweeps"),
        ],
    ),
    **swept(_FIT, OUTLIERS, [("outlyingRatio", "1.5", "6", "local means")]),
    **fixed(
        "core/fit/few_points.cpp",
        [
            ("mostInterpolated", "vertices", "all pairs with the points are compared"),
            (
                "samplesPerPoint",
                "samples a point",
                "time follows from it: the same points are found",
            ),
            ("bulge", "diagonals", "a promise; meshes of more than a few dozen vertices keep it"),
        ],
    ),
    **fixed(
        "core/free_memory.cpp",
        [("bytesPerVertex", "bytes", "what is refused follows from it, no mesh")],
    ),
    **fixed(
        "core/parameters.cpp",
        [
            ("mostSmoothingPasses", "passes", "what is refused follows from it, no mesh"),
            ("mostSignalsPerSplit", "signals", "what is refused follows from it, no mesh"),
        ],
    ),
    **fixed(_FIT, [("rounding", "diagonals", "rounding of double, 1e-16, times a margin")]),
    **swept(
        "core/fit/intersection_repair.cpp",
        ("plate", *SCANS),
        [
            ("roundsOfRestoring", "5", "20", "rounds"),
            ("roundsOfSmoothing", "10", "40", "rounds"),
            ("timesAlone", "2", "8", "moves"),
        ],
    ),
    **swept(
        "core/fit/boundary_reach.cpp",
        EDGES,
        [
            ("depthOfStrip", "0.125", "0.5", "heights of the face"),
            ("mostOffset", "0.5", "2", "heights of the face"),
            ("memory", "0.7", "0.925", "share kept"),
        ],
    ),
}

_OF_SPACE = {
    **fixed(
        "core/mesh/one_ring.h",
        [("inlineCapacity", "neighbours", "time follows from it: longer rings are rare")],
    ),
    **swept(
        "core/space/point_spacing.h",
        SPARSE,
        [("pointsPerVertex", "2.5", "10", "points a vertex")],
    ),
    **fixed(
        "core/space/vertex_grid.h",
        [("cellsPerVertex", "cells a vertex", "time follows from it, no mesh")],
    ),
    **fixed(
        "core/space/morton_order.cpp",
        [
            ("bitsPerAxis", "bits", "three axes fill 30 of the 32 bits of a key"),
            ("cellsPerAxis", "cells", "follows from bitsPerAxis"),
        ],
    ),
}

_OF_RESULT = fixed(
    ATTRIBUTES,
    [("pointsPerVertex", "points a vertex", "attributes follow from it, no mesh")],
)

CATALOGUE: dict[Key, Entry] = {
    **_LEARNING,
    **_OF_NETWORK,
    **_OF_GROWTH,
    **_OF_FIT,
    **_OF_SPACE,
    **OF_SAMPLERS,
    **OF_FILES,
    **_OF_RESULT,
}
