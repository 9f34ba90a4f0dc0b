// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/point_cloud_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <unordered_set>

#include "core/errors.h"
#include "core/point_statistics.h"

namespace neuralmesh {
namespace {

/// Extent, as a share of the diagonal, below which points count as lying on a plane or a line:
/// above the rounding of single-precision input, below any real relief.
constexpr double flatExtent = 1e-6;

/// Up to so many points are sifted for outliers beforehand; of more, those that are drawn.
constexpr std::size_t mostPointsSifted = 200000;

struct PointHash {
    std::size_t operator()(const Point3 &p) const
    {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = p[axis] + 0.0; // -0 and 0 are one place
            std::uint64_t bits = 0;
            std::memcpy(&bits, &coordinate, sizeof bits);
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32;
        }
        return static_cast<std::size_t>(hash);
    }
};

bool isFinite(const vcg::Point3d &p)
{
    return std::isfinite(p.X()) && std::isfinite(p.Y()) && std::isfinite(p.Z());
}

void requireFinite(const std::vector<vcg::Point3d> &points)
{
    std::size_t broken = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!isFinite(points[i]) && broken++ == 0)
            first = i;
    if (broken > 0)
        throw InvalidInput(
            std::to_string(broken) + " of " + std::to_string(points.size()) +
            " points have coordinates that are NaN or infinite (the first is point " +
            std::to_string(first) + "). Remove them and try again.");
}

/// Widths of the points along their principal axes, ascending, in units of the diagonal.
Eigen::Vector3d principalWidths(const std::vector<Point3> &points)
{
    const PrincipalAxes frame = principalAxes(points);
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    for (const Point3 &p : points) {
        const Eigen::Vector3d along = frame.axes.transpose() * (toEigen(p) - frame.mean);
        low = low.cwiseMin(along);
        high = high.cwiseMax(along);
    }
    return high - low;
}

void requireSolid(const std::vector<Point3> &points)
{
    const Eigen::Vector3d widths = principalWidths(points);
    if (widths[1] < flatExtent)
        throw InvalidInput("All points lie on a line: there is no surface to reconstruct.");
    if (widths[0] < flatExtent)
        throw InvalidInput("All points lie on a plane: a closed surface, which this filter "
                           "makes, cannot be fitted to them.");
}

} // namespace

PointCloudSampler::PointCloudSampler(const std::vector<vcg::Point3d> &world)
{
    if (world.empty())
        throw InvalidInput("There are no points to reconstruct a surface from.");
    requireFinite(world);
    vcg::Box3d worldBounds;
    for (const vcg::Point3d &p : world)
        worldBounds.Add(p);
    if (!std::isfinite(worldBounds.Diag()))
        throw InvalidInput("The points' coordinates are too large: their bounding box's diagonal "
                           "is not finite.");
    if (worldBounds.Diag() <= 0)
        throw InvalidInput("All points lie in one place: there is no surface to reconstruct.");
    frame_ = UnitFrame(worldBounds);
    points_.reserve(world.size());
    for (const vcg::Point3d &p : world) {
        points_.push_back(frame_.toUnit(p));
        bounds_.Add(points_.back());
    }
    if (const std::size_t distinct = countDistinctPoints(4); distinct < 4)
        throw InvalidInput("Only " + std::to_string(distinct) +
                           " distinct points: a closed surface needs at least 4.");
    setAsideOutliers();
    requireSolid(points_);
}

void PointCloudSampler::setAsideOutliers()
{
    OutlierFilter filter(points_, bounds_);
    outlierShare_ = filter.share();
    if (!filter.isActive())
        return;
    if (points_.size() > mostPointsSifted) {
        outliers_.emplace(std::move(filter));
        return;
    }
    const auto end = std::remove_if(points_.begin(), points_.end(),
                                    [&](const Point3 &point) { return filter.isOutlier(point); });
    points_.erase(end, points_.end());
}

void PointCloudSampler::draw(Random &random, std::size_t count, std::vector<Point3> &samples) const
{
    samples.resize(count);
    for (Point3 &sample : samples) {
        // At most a fifth are outliers: 64 in a row do not happen.
        for (int tries = 0; tries < 64; ++tries) {
            sample = points_[random.below(points_.size())];
            if (!outliers_ || !outliers_->isOutlier(sample))
                break;
        }
    }
}

std::size_t PointCloudSampler::countDistinctPoints(std::size_t enough) const
{
    std::unordered_set<Point3, PointHash> seen;
    seen.reserve(std::min(enough, points_.size()));
    for (const Point3 &p : points_) {
        seen.insert(p);
        if (seen.size() >= enough)
            break;
    }
    return seen.size();
}

} // namespace neuralmesh
