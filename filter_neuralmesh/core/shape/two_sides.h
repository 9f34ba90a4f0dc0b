// SPDX-License-Identifier: GPL-3.0-or-later
// Tells a plate, a wall with points on both of its sides, from a sheet with noise.
#pragma once

#include <vector>

#include "core/space/point_index.h"

namespace neuralmesh {

/// Whether the points lie on two sides of a wall that is thinner than the radius, and at least that
/// thick. Around most of them, then, the heights above the best quadric (of x, y, x², xy, y²) have
/// two peaks. Noise has one, and so has the rounding of coordinates, which is uniform.
bool haveTwoSides(const PointIndex &index, double radius, double leastThickness);

/// The points of the side of a wall that lies behind the other, seen against their normals, where
/// both sides have the same ones. Refers to points and normals, which have to stay.
class InnerSides {
public:
    /// Normals are of any length.
    InnerSides(const std::vector<Point3> &points, const std::vector<vcg::Point3f> &normals,
               double radius, double leastThickness);

    /// Whether the heights of the points around this one, along its normal, have two peaks, of
    /// which it is at the lower, and the points at the upper one have normals to the same side.
    /// Where they have opposite ones, there is a gap between two walls.
    bool hasPoint(std::size_t index) const;

private:
    PointIndex index_;
    const std::vector<vcg::Point3f> &normals_;
    double radius_;
    double leastThickness_;
};

} // namespace neuralmesh
