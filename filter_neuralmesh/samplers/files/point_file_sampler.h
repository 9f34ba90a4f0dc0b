// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/space/plain_points.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"
#include "samplers/files/mapped_file.h"
#include "samplers/files/point_layout.h"
#include "samplers/points/outlier_filter.h"

namespace neuralmesh {

/// The points of a file as target space, each with the same probability (equation 1), drawn in
/// place: nothing of the file is kept in memory, whatever its size. Outliers are not drawn. Of the
/// same points in memory, with no outliers, it draws the very same samples.
class PointFileSampler : public Sampler {
public:
    /// Opens a file of binary PLY, LAS or NPY. Takes one pass over it to find the bounds and
    /// points that are not finite, except where a LAS header claims bounds that fit its points.
    /// Throws InvalidPointFile where it is missing, broken or of another format,
    /// and where its points are such that PointCloudSampler refuses them; Cancelled.
    explicit PointFileSampler(const std::string &path, const Progress &progress = {});

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return toPlain(bounds_); }
    bool isFlat() const override { return isFlat_; }
    /// Throws InvalidPointFile where the file has been changed since it was opened.
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override;
    std::size_t pointCount() const override;
    /// Reads the file from its start until it has found enough.
    std::size_t countDistinctPoints(std::size_t enough) const override;

    double outlierShare() const override { return outliers_ ? outliers_->share() : 0; }

private:
    void setFrame(const vcg::Box3d &worldBounds);
    std::vector<Point3> readPilot() const;
    vcg::Box3d findWorldBounds(const Progress &progress) const;
    Point3 unitPoint(std::uint64_t index) const { return toUnit(frame_, records_.point(index)); }
    void drawAtOnce(Random &random, std::size_t count, Point *samples) const;
    Point3 drawNoOutlier(Random &random) const;

    std::string path_;
    MappedFile file_;
    PointRecords records_;
    UnitFrame frame_;
    bool isFlat_ = false;
    Box3 bounds_;
    std::optional<OutlierFilter> outliers_; ///< where there are any
};

} // namespace neuralmesh
