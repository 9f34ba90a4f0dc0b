// SPDX-License-Identifier: GPL-3.0-or-later
// What shape a field on a grid says that there is.
#pragma once

#include <vector>

#include "core/shape/grid.h"
#include "core/shape/marching_tetrahedra.h"

namespace neuralmesh {

/// A level set of the field, without the parts that hold hardly any of the points.
struct LevelSurface {
    TriangleSoup soup;
    int components = 0;
    int genus = 0; ///< sum over the components
    /// Share of the points that are far from the surface.
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
    /// A part of the surface counts where it has at least so many points for its own.
    static constexpr double leastPoints = 12;

    /// With the shape of most levels, from the level nearest to 0 that has it; where fewer than
    /// `fewestVotes` agree, the simplest.
    LevelSurface surface;
    int votes = 0;
};

/// `inside` is positive inside, at most 1 and not positive at the border of the grid. A point is
/// far from the surface from `far` cells on.
ShapeReading readShape(const Grid &inside, const std::vector<Point3> &points, double far,
                       int fewestVotes);

} // namespace neuralmesh
