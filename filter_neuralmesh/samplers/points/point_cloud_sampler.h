// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/space/alias_table.h"
#include "core/space/plain_points.h"
#include "neuralmesh/sampler.h"
#include "samplers/points/order_of_points.h"

namespace neuralmesh {

/// A point cloud as target space: every point with the same probability (equation 1), but for
/// outliers, which are not drawn and do not count for the bounds; or in proportion to a density. Of
/// strata, points are drawn as density_weights.h says.
class PointCloudSampler : public Sampler {
public:
    /// Takes points in world coordinates, and their memory where they are moved. Throws
    /// InvalidInput where fewer than four are distinct, where one is not finite, and where all lie
    /// in one place or on a line.
    ///
    /// Where `density` is given, one value for each point, not negative, points are drawn in
    /// proportion to it. It says how much each of them counts: those of density 0 are as if they
    /// were not there, and none is left out as an outlier.
    explicit PointCloudSampler(std::vector<Point> world, const std::vector<double> &density = {});

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return toPlain(bounds_); }
    bool isFlat() const override { return isFlat_; }
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override;
    /// Strata are of points that are near each other and weigh the same together.
    void drawStratified(Random &random, const Strata &strata,
                        std::vector<Point> &samples) const override;
    std::size_t pointCount() const override { return points_.size(); }
    std::size_t countDistinctPoints(std::size_t enough) const override;

    Outliers outliers() const override { return outliers_; }

private:
    void keep(std::vector<Point> world, const std::vector<bool> &isKept);
    void weighBy(const std::vector<double> &density);
    template <class NextIndex> void gather(std::vector<Point> &samples, NextIndex nextIndex) const;
    std::size_t drawIndex(Random &random) const;

    Outliers outliers_;
    std::optional<AliasTable> byDensity_;
    UnitFrame frame_;
    bool isFlat_ = false;
    Box3 bounds_;
    std::vector<Point> points_; ///< in the unit frame
    OrderOfPoints order_;
};

} // namespace neuralmesh
