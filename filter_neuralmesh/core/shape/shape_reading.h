// SPDX-License-Identifier: GPL-3.0-or-later
// What shape a field on a grid says that there is.
#pragma once

#include <cstddef>
#include <vector>

#include "core/parallel/workers.h"
#include "core/shape/grid.h"
#include "core/shape/marching_tetrahedra.h"

namespace neuralmesh {

/// A level set of the field, without the parts that hold hardly any of the points.
struct LevelSurface {
    TriangleSoup soup;
    int components = 0;
    int genus = 0; ///< sum over the components
    /// Points that are far from the surface, and their share of all.
    std::vector<Point3> missed;
    double missedShare = 0;

    bool hasShapeOf(const LevelSurface &other) const
    {
        return components == other.components && genus == other.genus;
    }
};

/// The level set at several levels around 0. What is there at most of them is shape; what comes and
/// goes, where parts nearly touch or thin out, is chance.
struct ShapeReading {
    /// Levels at which the shape is read.
    static constexpr int levelCount = 5;
    /// Of these, so many must agree for a shape that the coarser grid had already; and for that of
    /// an open sheet to be trusted on the first grid, since finer ones tear it where outliers are
    /// near. Where all of them agree on two grids, nothing is narrow.
    static constexpr int fewestVotes = 3;
    static constexpr int clearVotes = 4;
    /// A part of the surface counts where it has at least so many points for its own.
    static constexpr double leastPoints = 24;

    std::vector<LevelSurface> surfaces; ///< that nearest to the points first
    std::size_t mostFrequent = 0;       ///< the first of those whose shape most levels have
    std::size_t simplest = 0;           ///< the first of those of fewest parts and handles
    int votes = 0;                      ///< levels with the most frequent shape
    /// Share of the points that lie more than a cell from level 0, by what the field is there and
    /// its slope (Taubin 1991): of narrow holes that are filled, gaps that are bridged, and noise.
    double unexplainedShare = 0;

    /// With the shape of most levels; where fewer than so many agree, the simplest.
    const LevelSurface &surface(int fewest) const
    {
        return surfaces[votes >= fewest ? mostFrequent : simplest];
    }
};

/// `inside` is positive inside, at most 1 and not positive at the border of the grid. A point is
/// far from the surface from `far` cells on.
ShapeReading readShape(Workers &workers, const Grid &inside, const std::vector<Point3> &points,
                       double far);

/// Where levels disagree: has lower ones for the simplest, too, at which the shape is fatter, if
/// these have fewer handles and as many parts. A wall that is hardly thicker than its points are
/// apart has tunnels at random, which close; a hole of the data is outside at all of them. After
/// readShape(), of the same.
void closeTunnels(ShapeReading &reading, Workers &workers, const Grid &inside,
                  const std::vector<Point3> &points, double far);

/// Whether the finer grid shows the noise of the points: it leaves many unexplained, and explains
/// hardly more than the coarser one.
bool isOfNoise(const ShapeReading &finer, const ShapeReading &coarser);

} // namespace neuralmesh
