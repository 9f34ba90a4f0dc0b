// SPDX-License-Identifier: GPL-3.0-or-later
// The frame in which the network grows: centred, with the bounding box's diagonal as the unit.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Maps between world coordinates and the unit frame, in double precision, so that data far from
/// the origin (UTM coordinates, say) loses nothing.
class UnitFrame {
public:
    UnitFrame() = default;

    /// The frame of a bounding box in world coordinates that is not a single point.
    explicit UnitFrame(const vcg::Box3d &worldBounds)
        : centre_(worldBounds.Center()), diagonal_(worldBounds.Diag())
    {
    }

    double diagonal() const { return diagonal_; }

    Point3 toUnit(const vcg::Point3d &world) const
    {
        return Point3::Construct((world - centre_) / diagonal_);
    }
    vcg::Point3d toWorld(const Point3 &unit) const
    {
        return vcg::Point3d::Construct(unit) * diagonal_ + centre_;
    }

private:
    vcg::Point3d centre_{0, 0, 0};
    double diagonal_ = 1;
};

} // namespace neuralmesh
