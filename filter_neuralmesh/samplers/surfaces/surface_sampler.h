// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/space/alias_table.h"
#include "core/space/plain_points.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// The surface of a triangle mesh as target space: uniform by area, in constant time a sample.
class SurfaceSampler : public Sampler {
public:
    /// Takes points in world coordinates and the faces between them, which may form any set of
    /// triangles; those without area are never drawn. Where `density` is given, one value for each
    /// point, not negative, samples are drawn in proportion to it, linear on each face.
    ///
    /// Throws InvalidInput where no face has an area (and a density), where a point is not finite,
    /// and where all faces lie in one plane, which cannot carry a closed surface.
    SurfaceSampler(const std::vector<Point> &world, const std::vector<Corners> &faces,
                   const std::vector<double> &density = {});

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return toPlain(bounds_); }
    bool isFlat() const override { return isFlat_; }
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override;

private:
    UnitFrame frame_;
    bool isFlat_ = false;
    Box3 bounds_;
    std::vector<Point3> points_;  ///< in the unit frame
    std::vector<Corners> faces_;  ///< those that have a weight
    std::vector<double> density_; ///< by point, or empty where it is the same everywhere
    AliasTable table_;
};

} // namespace neuralmesh
