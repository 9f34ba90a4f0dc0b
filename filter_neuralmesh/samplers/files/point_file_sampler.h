// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/space/plain_points.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"
#include "samplers/files/mapped_file.h"
#include "samplers/files/point_layout.h"
#include "samplers/points/order_of_points.h"
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
    /// and where its points are such that PointCloudSampler refuses them; Cancelled. Where time is
    /// up, the points are those that were looked at until then, some of the first.
    explicit PointFileSampler(const std::string &path, const Progress &progress = {});

    const UnitFrame &frame() const override { return frame_; }
    Box bounds() const override { return toPlain(bounds_); }
    bool isFlat() const override { return isFlat_; }
    /// Throws InvalidPointFile where the file has been changed since it was opened.
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override;
    /// Strata are of records that are near each other, or of very many follow each other.
    void drawStratified(Random &random, const Strata &strata,
                        std::vector<Point> &samples) const override;
    std::size_t pointCount() const override;
    /// Reads the file from its start until it has found enough.
    std::size_t countDistinctPoints(std::size_t enough) const override;

    /// Of points that a LAS header's bounds exclude, and no pilot point is, none is counted.
    Outliers outliers() const override { return left_; }

private:
    void setFrame(const vcg::Box3d &worldBounds);
    void setAsideOutliers(const vcg::Box3d &worldBounds, const Progress &progress);
    vcg::Box3d findWorldBounds(const Progress &progress);
    void countOutliers(const Progress &progress);
    bool isToBeDrawn(const Point3 &world) const;
    template <class Index>
    void drawEach(Random &random, const Index &index, std::vector<Point> &samples) const;
    template <class Index>
    void drawAtOnce(Random &random, std::size_t first, std::size_t end, const Index &index,
                    Point *samples) const;
    Point3 drawAnother(Random &random) const;

    std::string path_;
    MappedFile file_;
    PointRecords records_;
    UnitFrame frame_;
    bool isFlat_ = false;
    Box3 bounds_;
    OrderOfPoints order_;
    OutlierFilter filter_;
    bool judgesEach_ = false; ///< whether outliers are among the points within the bounds
    vcg::Box3d drawn_;        ///< in the world: no point is drawn outside
    Outliers left_;
};

} // namespace neuralmesh
