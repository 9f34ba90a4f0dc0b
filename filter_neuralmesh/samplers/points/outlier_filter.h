// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/space/point_grid.h"
#include "core/space/point_tree.h"
#include "samplers/points/distinct_points.h"
#include "samplers/points/robust_frame.h"

namespace neuralmesh {

/// Every n-th of `count` points: `most` of them, or all.
template <class PointAt>
std::vector<Point3> everyNth(std::uint64_t count, std::size_t most, const PointAt &pointAt)
{
    const std::uint64_t chosen = std::min<std::uint64_t>(count, most);
    std::vector<Point3> points;
    points.reserve(static_cast<std::size_t>(chosen));
    // No overflow: a mapped file holds fewer than 2^44 points.
    for (std::uint64_t i = 0; i < chosen; ++i)
        points.push_back(pointAt(i * count / chosen));
    return points;
}

/// Tells points that stand alone from points of a surface, in constant time for each, whatever the
/// size of the cloud: by how many of at most 20,000 pilot points lie around.
///
/// A point is an outlier where fewer than eight pilot points lie within a radius that is several
/// times the usual distance to the eighth, unless it is of a part of the data that is only sparser
/// (sparse_parts.h). Where the density of the cloud varies, so does that distance, and the radius
/// grows with its spread. In a cloud that is all pilot points, where a single one can move a
/// vertex, so is one off the plane of its neighbours which is further from them than they are from
/// theirs (local outlier factor, Breunig et al. 2000). So are the points of a group of next to no
/// size that is apart from all others, for its own density. None is an outlier in a cloud of fewer
/// than 500 points, or where more than a fifth of the places would be: that is how the cloud is,
/// not dirt in it. Points at the very same place count as one: invalid returns are often stored as
/// 0 0 0.
///
/// Pilot points tell whether a cloud has outliers. In one that has, up to 100,000 take their place:
/// their spacing is smaller, so that they tell a stray near a surface from the surface, and the
/// parts that are sparser from strays.
class OutlierFilter {
public:
    /// Pilot points at the most.
    static constexpr std::size_t pilotPoints = 20000;
    /// Where these hold an outlier.
    static constexpr std::size_t morePilotPoints = 100000;

    /// Of no cloud: not active.
    OutlierFilter() : pilotGrid_(RobustFrame::usualBox(), pilot_) {}

    /// Learns from every n-th of the points, given in any unit and however far from each other.
    explicit OutlierFilter(const std::vector<Point3> &points);

    /// The same of `count` points, of which pointAt(i) gives one.
    template <class PointAt> static OutlierFilter of(std::uint64_t count, const PointAt &pointAt)
    {
        const bool isWhole = count <= pilotPoints;
        OutlierFilter filter(everyNth(count, pilotPoints, pointAt), isWhole);
        if (!isWhole && filter.share() > 0)
            if (OutlierFilter closer(everyNth(count, morePilotPoints, pointAt), isWhole);
                closer.isActive())
                return closer;
        return filter;
    }

    /// Whether the cloud is one in which outliers are told from others. Where not, none is one.
    bool isActive() const { return isActive_; }

    /// Share of outliers among the pilot points, each counted however often it is repeated.
    double share() const { return share_; }

    /// Of the pilot points that are no outliers, and as far around as these reach: a point outside
    /// is an outlier. Only where the filter is active.
    const Box3 &bounds() const { return bounds_; }

    bool isOutlier(const Point3 &point) const { return isActive_ && isDirt(frame_.toFrame(point)); }

private:
    OutlierFilter(const std::vector<Point3> &drawn, bool isWhole);
    void learn(bool isWhole);
    void findSparseParts();
    void findSmallGroups();
    bool isDirt(const Point3 &inFrame) const;
    bool isDirtNear(std::size_t pilot, double distance, bool isAlone) const;
    bool isAlone(const Point3 &inFrame) const;

    RobustFrame frame_;
    std::vector<Point3> pilot_; ///< in the robust frame
    PointGrid pilotGrid_;
    std::vector<bool> isAlone_;        ///< by pilot point
    std::vector<bool> isInSmallGroup_; ///< by pilot point
    std::vector<double> reaches_;      ///< by pilot point: in a sparse part, of others around it
    DistinctPoints strays_;            ///< not alone, but off the surface of their neighbours
    Box3 bounds_;
    Scalar radius_ = 0;
    double share_ = 0;
    bool isActive_ = false;
};

} // namespace neuralmesh
