// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/point_cloud_sampler.h"

#include <algorithm>

#include "neuralmesh/errors.h"
#include "samplers/input_checks.h"
#include "samplers/points/distinct_points.h"

namespace neuralmesh {
namespace {

/// Up to so many points are sifted for outliers beforehand; of more, those that are drawn.
constexpr std::size_t mostPointsSifted = 200000;

} // namespace

PointCloudSampler::PointCloudSampler(const std::vector<Point> &world,
                                     const std::vector<double> &given)
{
    if (world.empty())
        throw InvalidInput("There are no points to reconstruct a surface from.");
    const std::vector<double> density = densityShares(given, world.size());
    requireFinite(world);
    const auto isDrawn = [&](std::size_t i) { return density.empty() || density[i] > 0; };
    vcg::Box3d worldBounds;
    for (std::size_t i = 0; i < world.size(); ++i)
        if (isDrawn(i))
            worldBounds.Add(toVcg(world[i]));
    setFrame(worldBounds);
    points_.reserve(world.size());
    std::vector<double> weights;
    for (std::size_t i = 0; i < world.size(); ++i) {
        if (!isDrawn(i))
            continue;
        points_.push_back(toVcg(frame_.toUnit(world[i])));
        if (!density.empty())
            weights.push_back(density[i]);
    }
    requireFourPoints(countDistinctPoints(4));
    if (density.empty())
        setAsideOutliers(world);
    else
        byDensity_.emplace(weights);
    isFlat_ = neuralmesh::isFlat(points_);
}

void PointCloudSampler::setFrame(const vcg::Box3d &worldBounds)
{
    frame_ = frameOf(worldBounds);
    bounds_ = Box3(toUnit(frame_, worldBounds.min), toUnit(frame_, worldBounds.max));
}

/// Outliers may lie so far off that the rest is next to nothing in the frame of all.
void PointCloudSampler::setAsideOutliers(const std::vector<Point> &world)
{
    const OutlierFilter filter(points_, bounds_);
    outlierShare_ = filter.share();
    if (!filter.isActive())
        return;
    if (points_.size() > mostPointsSifted) {
        setFrame(toWorld(frame_, filter.bounds()));
        for (std::size_t i = 0; i < world.size(); ++i)
            points_[i] = toVcg(frame_.toUnit(world[i]));
        outliers_.emplace(points_, bounds_);
        return;
    }
    std::vector<Point> rest;
    vcg::Box3d worldBounds;
    for (std::size_t i = 0; i < world.size(); ++i)
        if (!filter.isOutlier(points_[i])) {
            rest.push_back(world[i]);
            worldBounds.Add(toVcg(world[i]));
        }
    setFrame(worldBounds);
    points_.clear();
    for (const Point &point : rest)
        points_.push_back(toVcg(frame_.toUnit(point)));
}

void PointCloudSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.resize(count);
    for (Point &sample : samples) {
        // At most a fifth are outliers: 64 in a row do not happen.
        for (int tries = 0; tries < 64; ++tries) {
            const Point3 &point = points_[drawIndex(random)];
            sample = toPlain(point);
            if (!outliers_ || !outliers_->isOutlier(point))
                break;
        }
    }
}

std::size_t PointCloudSampler::drawIndex(Random &random) const
{
    return byDensity_ ? byDensity_->draw(random)
                      : static_cast<std::size_t>(random.below(points_.size()));
}

std::size_t PointCloudSampler::countDistinctPoints(std::size_t enough) const
{
    DistinctPoints distinct(std::min(enough, points_.size()));
    for (const Point3 &p : points_) {
        distinct.insert(p);
        if (distinct.size() >= enough)
            break;
    }
    return distinct.size();
}

} // namespace neuralmesh
