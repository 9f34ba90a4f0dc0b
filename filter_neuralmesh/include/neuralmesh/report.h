// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace neuralmesh {

/// What became of the shape of the data.
enum class LearnedShape {
    /// Topology::ofStart, or a starting mesh that was given.
    notAsked,
    /// Growth started from it.
    found,
    /// Growth started from a solid, whose topology the result has.
    notFound,
    /// The time was up before: the result is the solid.
    notFinished
};

/// Where the time of a run was up.
enum class TimeUp {
    no,           ///< or only when the mesh was finished
    inGrowth,     ///< the mesh lacks vertices, or lacks them where errors are
    inSurfaceFit, ///< the mesh has its vertices, but is not fitted
};

/// What was opened, joined and filled on the way to a result.
struct TopologyChanges {
    LearnedShape shape = LearnedShape::notAsked;
    bool isShapeClear = true; ///< false where levels and grids disagree on the shape that was found
    int gaps = 0;             ///< in the data, at which the starting mesh was opened
    int websRemoved = 0;      ///< faces across a void from one limb to another
    int holesFilled = 0;      ///< boundaries closed by discs
    int sheetsDoubled = 0;    ///< components closed by a second sheet behind the first
};

/// What is to be told about a result. Distances are in units of the input.
struct Report {
    int vertices = 0;
    int faces = 0;
    int components = 0;
    /// Sum of the components' genera.
    int genus = 0;
    int boundaryLoops = 0;
    /// Entry k counts the vertices of valence k.
    std::vector<int> valenceHistogram;

    std::uint64_t signalCount = 0;   // not "signals", which is a macro of Qt
    std::uint64_t splitCount = 0;    ///< vertices that came, those of cut handles among them
    std::uint64_t collapseCount = 0; ///< vertices that went, those of webs among them
    /// Faces that intersect another.
    int selfIntersections = 0;
    /// Whether the mesh is finished: it has as many vertices as were asked for, and no deadline cut
    /// its growth or its fit short.
    bool reachedTarget = false;
    TimeUp timeUp = TimeUp::no;
    /// Whether vertices were kept that win no sample: for want of points, or since growth folded
    /// and got nowhere.
    bool keptIdle = false;

    TopologyChanges changes;

    /// Distances of fresh samples from the mesh.
    double rmsError = 0;
    double maxError = 0;
    /// Share of the points that are near the mesh: nearer than its mean edge length or, where the
    /// points are sparse, than their spacing. 1 where nothing was left out but isolated points.
    double coverage = 0;
    /// Share of the mesh's area that is far from all points, by the same measure, and further than
    /// twice the spacing of the points around the nearest one: of membranes over holes in the data,
    /// and of webs.
    double unsupportedArea = 0;
    /// Root mean square distance of samples from the growing network as it reached 8, 16, 32 ...
    /// vertices: entry k at 8 * 2^k. Below the count of a starting mesh: of the start, cut down to
    /// so many.
    std::vector<double> convergence;
};

} // namespace neuralmesh
