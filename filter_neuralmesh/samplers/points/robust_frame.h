// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A frame that a fifth of the points cannot move, however far off they are: about the middle half
/// of the coordinates along each axis. Distances in it are true up to a million times the extent of
/// that half. Beyond they grow with the logarithm only, so that the least and the largest numbers
/// that there are stay far, finite and apart.
class RobustFrame {
public:
    RobustFrame() = default;

    /// Of points that are finite, at least one.
    explicit RobustFrame(const std::vector<Point3> &points);

    Point3 toFrame(const Point3 &point) const;

    /// Whether a place in the frame is so far off that distances there are not true.
    static bool isFarAway(const Point3 &inFrame);

    /// Its unit of length.
    Scalar unit() const { return unit_; }

    /// A box in which most of the points are.
    static Box3 usualBox() { return {{-2, -2, -2}, {2, 2, 2}}; }

private:
    Point3 middle_{0, 0, 0};
    Scalar unit_ = 1;
};

} // namespace neuralmesh
