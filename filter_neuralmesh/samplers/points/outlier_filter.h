// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/space/vertex_grid.h"
#include "samplers/points/distinct_points.h"

namespace neuralmesh {

/// Tells points that stand alone from points of a surface, in constant time for each, whatever the
/// size of the cloud: by how many of at most 20,000 pilot points lie around.
///
/// A point is an outlier where fewer than eight pilot points lie within a radius that is several
/// times the usual distance to the eighth. Where the density of the cloud varies, so does that
/// distance, and the radius grows with its spread. In a cloud that is all pilot points, where a
/// single one can move a vertex, so is one off the plane of its neighbours which is further from
/// them than they are from theirs (local outlier factor, Breunig et al. 2000). So are the points of
/// a group of next to no size that is apart from all others, for its own density. None is an
/// outlier in a cloud of fewer than 500 points, where more than a fifth of the places would be, or
/// where those that would be lie on surfaces of their own, as a sparsely scanned part does: that is
/// how the cloud is, not dirt in it. Points at the very same place count as one: invalid returns
/// are often stored as 0 0 0.
class OutlierFilter {
public:
    /// Pilot points at the most.
    static constexpr std::size_t pilotPoints = 20000;

    /// Learns from the points, in the unit frame.
    OutlierFilter(const std::vector<Point3> &points, const Box3 &bounds);

    /// Whether any outlier was found among the pilot points; where not, none is an outlier.
    bool isActive() const { return share_ > 0; }

    /// Share of outliers among the pilot points, each counted however often it is repeated.
    double share() const { return share_; }

    /// Of the pilot points that are no outliers, and as far around as these reach.
    const Box3 &bounds() const { return bounds_; }

    bool isOutlier(const Point3 &point) const { return isActive() && isDirt(point); }

private:
    void insert(const std::vector<Point3> &pilot);
    void judgeThoseAlone(const std::vector<Point3> &pilot);
    bool isDirt(const Point3 &point) const;
    bool isAlone(const Point3 &point) const;

    VertexGrid pilotGrid_;
    std::vector<bool> isInSmallGroup_; ///< by pilot point
    DistinctPoints strays_;            ///< not alone, but off the surface of their neighbours
    Box3 bounds_;
    Scalar radius_ = 0; ///< 0 where standing alone says nothing
    double share_ = 0;
};

} // namespace neuralmesh
