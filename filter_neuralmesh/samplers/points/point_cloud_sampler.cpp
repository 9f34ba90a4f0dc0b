// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/point_cloud_sampler.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/portability.h"
#include "neuralmesh/errors.h"
#include "samplers/input_checks.h"
#include "samplers/points/density_weights.h"
#include "samplers/points/distinct_points.h"
#include "samplers/points/outlier_filter.h"

namespace neuralmesh {
namespace {

/// Of so many points each is judged by itself. Of more, each is only where the pilot points hold an
/// outlier, or where a point lies out of the reach of those that are none; one that is left has
/// next to no chance of being drawn.
constexpr std::size_t mostPointsJudged = 200000;

/// Points that the memory is asked for before the first of them is read.
constexpr std::size_t readsAtOnce = 64;

std::vector<bool> withDensity(const std::vector<double> &density)
{
    std::vector<bool> isKept;
    isKept.reserve(density.size());
    for (const double value : density)
        isKept.push_back(value > 0);
    return isKept;
}

/// Which points are to be drawn, and how many of the others are outliers.
struct Choice {
    std::vector<bool> isKept;
    std::size_t outliers = 0;
};

/// Points at the very same place are one, where they are few enough to be compared: returns that
/// are stored a thousand times would have as many vertices as a thousand others.
Choice withoutOutliers(const std::vector<Point> &world)
{
    const bool areCompared = world.size() <= mostPointsJudged;
    std::vector<Point3> places;
    Choice choice{std::vector<bool>(world.size(), true)};
    if (areCompared) {
        DistinctPoints seen(world.size());
        for (std::size_t i = 0; i < world.size(); ++i) {
            choice.isKept[i] = seen.insert(toVcg(world[i]));
            if (choice.isKept[i])
                places.push_back(toVcg(world[i]));
        }
    }
    const auto pointAt = [&](std::uint64_t i) { return toVcg(world[i]); };
    const OutlierFilter filter =
        areCompared ? OutlierFilter(places) : OutlierFilter::of(world.size(), pointAt);
    if (!filter.isActive())
        return choice;
    const bool isWithin = std::all_of(world.begin(), world.end(), [&](const Point &point) {
        return filter.bounds().IsIn(toVcg(point));
    });
    if (!areCompared && isWithin && !(filter.share() > 0))
        return choice;
    for (std::size_t i = 0; i < world.size(); ++i)
        if (filter.isOutlier(toVcg(world[i]))) {
            choice.isKept[i] = false;
            ++choice.outliers;
        }
    return choice;
}

} // namespace

PointCloudSampler::PointCloudSampler(std::vector<Point> world, const std::vector<double> &given)
{
    if (world.empty())
        throw InvalidInput("There are no points to reconstruct a surface from.");
    const std::vector<double> density = densityShares(given, world.size());
    requireFinite(world);
    const Choice choice = density.empty() ? withoutOutliers(world) : Choice{withDensity(density)};
    outliers_.count = choice.outliers;
    outliers_.share =
        static_cast<double>(choice.outliers) / static_cast<double>(choice.isKept.size());
    keep(std::move(world), choice.isKept);
    requireFourPoints(countDistinctPoints(4));
    order_ = OrderOfPoints(points_.size(), bounds(), [&](std::size_t i) { return points_[i]; });
    if (density.empty())
        order_.weigh(weightsByDensity(
            points_.size(), [&](std::uint64_t place) { return points_[order_.at(place)]; }));
    else
        weighBy(density);
    isFlat_ = neuralmesh::isFlat(points_, outliers_.count);
}

/// By densities of all points that were given; those of density 0 were not kept.
void PointCloudSampler::weighBy(const std::vector<double> &density)
{
    std::vector<double> weights;
    std::copy_if(density.begin(), density.end(), std::back_inserter(weights),
                 [](double value) { return value > 0; });
    byDensity_.emplace(weights);
    std::vector<double> inOrder;
    inOrder.reserve(weights.size());
    for (std::size_t place = 0; place < weights.size(); ++place)
        inOrder.push_back(weights[order_.at(place)]);
    order_.weigh(inOrder);
}

/// Frame and bounds are those of the points that are kept: others may lie so far off that these are
/// next to nothing in the frame of all. In place: clouds are large.
void PointCloudSampler::keep(std::vector<Point> world, const std::vector<bool> &isKept)
{
    vcg::Box3d worldBounds;
    for (std::size_t i = 0; i < world.size(); ++i)
        if (isKept[i])
            worldBounds.Add(toVcg(world[i]));
    frame_ = frameOf(worldBounds);
    bounds_ = Box3(toUnit(frame_, worldBounds.min), toUnit(frame_, worldBounds.max));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < world.size(); ++i)
        if (isKept[i])
            world[kept++] = frame_.toUnit(world[i]);
    world.resize(kept);
    points_ = std::move(world);
}

/// The points at nextIndex(), as many as there are samples. Of a large cloud, hardly any of them is
/// in cache.
template <class NextIndex>
void PointCloudSampler::gather(std::vector<Point> &samples, NextIndex nextIndex) const
{
    std::array<std::size_t, readsAtOnce> indices;
    for (std::size_t first = 0; first < samples.size(); first += readsAtOnce) {
        const std::size_t count = std::min(readsAtOnce, samples.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            indices[i] = nextIndex();
            prefetch(&points_[indices[i]]);
        }
        for (std::size_t i = 0; i < count; ++i)
            samples[first + i] = points_[indices[i]];
    }
}

void PointCloudSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.resize(count);
    gather(samples, [&] { return drawIndex(random); });
}

void PointCloudSampler::drawStratified(Random &random, const Strata &strata,
                                       std::vector<Point> &samples) const
{
    samples.resize(strata.end - strata.first);
    gather(samples, [&, stratum = strata.first]() mutable {
        return order_.draw(random, stratum++, strata.count);
    });
}

std::size_t PointCloudSampler::drawIndex(Random &random) const
{
    return byDensity_ ? byDensity_->draw(random)
                      : static_cast<std::size_t>(random.below(points_.size()));
}

std::size_t PointCloudSampler::countDistinctPoints(std::size_t enough) const
{
    DistinctPoints distinct(std::min(enough, points_.size()));
    for (const Point &p : points_) {
        distinct.insert(toVcg(p));
        if (distinct.size() >= enough)
            break;
    }
    return distinct.size();
}

} // namespace neuralmesh
