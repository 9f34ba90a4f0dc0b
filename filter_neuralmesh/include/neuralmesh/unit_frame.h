// SPDX-License-Identifier: GPL-3.0-or-later
// The frame in which the network grows: centred, with the bounding box's diagonal as the unit.
#pragma once

#include <cmath>
#include <cstddef>

#include "neuralmesh/geometry.h"

namespace neuralmesh {

/// Maps between world coordinates and the unit frame, in double precision, so that data far from
/// the origin (UTM coordinates, say) loses nothing.
class UnitFrame {
public:
    UnitFrame() = default;

    /// The frame of a bounding box in world coordinates that is not a single point.
    explicit UnitFrame(const Box &worldBounds)
    {
        const Point &low = worldBounds.min;
        const Point &high = worldBounds.max;
        Point extent;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            centre_[axis] = (low[axis] + high[axis]) / 2;
            extent[axis] = high[axis] - low[axis];
        }
        diagonal_ =
            std::sqrt(extent[0] * extent[0] + extent[1] * extent[1] + extent[2] * extent[2]);
    }

    double diagonal() const { return diagonal_; }

    Point toUnit(const Point &world) const
    {
        return {(world[0] - centre_[0]) / diagonal_, (world[1] - centre_[1]) / diagonal_,
                (world[2] - centre_[2]) / diagonal_};
    }
    Point toWorld(const Point &unit) const
    {
        return {unit[0] * diagonal_ + centre_[0], unit[1] * diagonal_ + centre_[1],
                unit[2] * diagonal_ + centre_[2]};
    }

private:
    Point centre_{0, 0, 0};
    double diagonal_ = 1;
};

} // namespace neuralmesh
