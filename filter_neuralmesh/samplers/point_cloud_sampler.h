// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sampler.h"

namespace neuralmesh {

/// A point cloud as target space: every point with the same probability (equation 1).
class PointCloudSampler : public Sampler {
public:
    /// Takes points in world coordinates. Throws InvalidInput where fewer than four are distinct,
    /// where one is not finite, and where all lie in one place, on a line or on a plane, since
    /// none of these can carry a closed surface.
    explicit PointCloudSampler(const std::vector<vcg::Point3d> &world);

    const UnitFrame &frame() const override { return frame_; }
    Box3 bounds() const override { return bounds_; }
    void draw(Random &random, std::size_t count, std::vector<Point3> &samples) const override;
    std::size_t countDistinctPoints(std::size_t enough) const override;

private:
    UnitFrame frame_;
    Box3 bounds_;
    std::vector<Point3> points_; ///< in the unit frame
};

} // namespace neuralmesh
