// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/outlier_filter.h"

#include <cmath>

#include "core/space/point_statistics.h"
#include "core/space/point_tree.h"
#include "samplers/points/sparse_parts.h"

namespace neuralmesh {
namespace {

/// Of fewer points, none is an outlier: each may have been set by hand.
constexpr std::size_t leastPoints = 500;
/// Points whose distance to the eighth neighbour is measured. Fewer neighbours than eight are found
/// in the company of other outliers, too.
constexpr std::size_t measuredPoints = 1000;
constexpr int neighbours = 8;
/// The radius, in medians of the distance to the eighth neighbour, at the least: at the corner of a
/// sheet, a quarter of the disc holds twelve points.
constexpr double leastRatio = 2.5;
/// A stray is further from its neighbours than they from theirs by this factor, and off their plane
/// by this share of that distance.
constexpr double strayRatio = 1.7;
constexpr double strayHeight = 0.5;
/// The radius, in standard deviations of the logarithm of that distance above its median.
constexpr double deviations = 4;
/// Median absolute deviation to standard deviation, of a normal distribution.
constexpr double madToDeviation = 1.4826;
/// Pilot points of a group apart from all others that is no part of the data, as a share of all, up
/// to which its points are outliers: a mesh of 5,000 vertices would have a dozen for it.
constexpr double mostOfGroup = 0.0025;
/// Above this share of the places there are no outliers.
constexpr double mostOutliers = 0.2;

double measureRadius(PointTree &tree, const std::vector<Point3> &pilot)
{
    std::vector<double> logarithms;
    const std::size_t count = std::min(pilot.size(), measuredPoints);
    for (std::size_t i = 0; i < count; ++i)
        if (const double distance = tree.distance(pilot[i * pilot.size() / count], neighbours);
            distance > 0)
            logarithms.push_back(std::log(distance));
    if (logarithms.empty())
        return 0;
    const double usual = median(logarithms);
    std::vector<double> spread;
    for (const double value : logarithms)
        spread.push_back(std::abs(value - usual));
    const double deviation = madToDeviation * median(spread);
    return std::exp(usual + std::max(std::log(leastRatio), deviations * deviation));
}

std::vector<Point3> withoutRepetitions(const std::vector<Point3> &points)
{
    std::vector<Point3> distinct;
    DistinctPoints seen(points.size());
    for (const Point3 &point : points)
        if (seen.insert(point))
            distinct.push_back(point);
    return distinct;
}

/// Whether a pilot point is off the plane of its neighbours, and far from them as they are from
/// theirs.
bool strays(std::size_t index, const std::vector<Point3> &pilot, PointTree &tree,
            const std::vector<double> &distances)
{
    const std::vector<std::size_t> others = tree.neighbours(index, neighbours);
    std::vector<double> theirs;
    theirs.reserve(others.size());
    for (const std::size_t other : others)
        theirs.push_back(distances[other]);
    const double usual = median(std::move(theirs));
    if (distances[index] <= strayRatio * usual)
        return false;
    std::vector<Point3> around;
    for (const std::size_t other : others)
        if (distances[other] <= strayRatio * usual) // no stray itself
            around.push_back(pilot[other]);
    const PrincipalAxes plane = principalAxes(around);
    const double height = std::abs(plane.axes.col(0).dot(toEigen(pilot[index]) - plane.mean));
    return height > strayHeight * distances[index];
}

} // namespace

OutlierFilter::OutlierFilter(const std::vector<Point3> &points)
    : OutlierFilter(of(points.size(), [&](std::uint64_t i) { return points[i]; }))
{
}

OutlierFilter::OutlierFilter(const std::vector<Point3> &drawn, bool isWhole) : OutlierFilter()
{
    if (drawn.size() < leastPoints)
        return;
    const std::vector<Point3> places = withoutRepetitions(drawn);
    frame_ = RobustFrame(places);
    for (const Point3 &place : places)
        pilot_.push_back(frame_.toFrame(place));
    learn(isWhole);
    Box3 inFrame;
    std::size_t outliers = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (isDirtNear(i, 0, isAlone_[i])) {
            ++outliers;
            continue;
        }
        const Scalar reach = std::max<Scalar>(radius_, reaches_[i]);
        inFrame.Add(pilot_[i], reach);
        bounds_.Add(places[i], reach * frame_.unit());
    }
    if (static_cast<double>(outliers) > mostOutliers * static_cast<double>(places.size()))
        return;
    isActive_ = true;
    pilotGrid_ = PointGrid(inFrame, pilot_);
    if (drawn.size() > places.size()) // each counts however often it is repeated
        outliers = static_cast<std::size_t>(std::count_if(
            drawn.begin(), drawn.end(), [&](const Point3 &point) { return isOutlier(point); }));
    share_ = static_cast<double>(outliers) / static_cast<double>(drawn.size());
}

void OutlierFilter::learn(bool isWhole)
{
    pilotGrid_ = PointGrid(RobustFrame::usualBox(), pilot_);
    PointTree tree(pilot_);
    radius_ = measureRadius(tree, pilot_);
    if (isWhole) {
        const std::vector<double> distances = tree.distances(neighbours);
        for (std::size_t i = 0; i < pilot_.size(); ++i)
            if (strays(i, pilot_, tree, distances))
                strays_.insert(pilot_[i]);
    }
    for (const Point3 &point : pilot_)
        isAlone_.push_back(isAlone(point));
    findSparseParts();
    findSmallGroups();
}

/// Among those alone and all others at their spacing: of a part that is three times as sparse, some
/// points are alone, and some of their neighbours. Not among strays off a surface, nor so far away
/// that their distances are not true: many of these, at one distance, would be a surface
/// themselves.
void OutlierFilter::findSparseParts()
{
    reaches_.assign(pilot_.size(), 0);
    if (std::find(isAlone_.begin(), isAlone_.end(), true) == isAlone_.end())
        return;
    std::vector<std::size_t> indices;
    std::vector<Point3> sparse;
    for (std::size_t i = 0; i < pilot_.size(); ++i)
        if (!pilotGrid_.hasWithin(pilot_[i], radius_ / strayRatio, neighbours + 1) &&
            !strays_.contains(pilot_[i]) && !RobustFrame::isFarAway(pilot_[i])) {
            indices.push_back(i);
            sparse.push_back(pilot_[i]);
        }
    const std::vector<double> reaches = reachesInSparseParts(sparse);
    for (std::size_t i = 0; i < indices.size(); ++i)
        reaches_[indices[i]] = reaches[i];
}

/// Among all others: those alone would join what they lie between.
void OutlierFilter::findSmallGroups()
{
    std::vector<std::size_t> indices;
    std::vector<Point3> others;
    for (std::size_t i = 0; i < pilot_.size(); ++i)
        if (reaches_[i] > 0 || !isAlone_[i]) {
            indices.push_back(i);
            others.push_back(pilot_[i]);
        }
    isInSmallGroup_.assign(pilot_.size(), false);
    if (others.empty())
        return;
    const double most = mostOfGroup * static_cast<double>(pilot_.size());
    const std::vector<bool> isSmall = PointTree(others).inSmallGroups(leastRatio, neighbours, most);
    for (std::size_t i = 0; i < indices.size(); ++i)
        isInSmallGroup_[indices[i]] = isSmall[i];
}

bool OutlierFilter::isDirt(const Point3 &inFrame) const
{
    const VertexId nearest = pilotGrid_.nearest(inFrame);
    return isDirtNear(nearest, (pilot_[nearest] - inFrame).Norm(), isAlone(inFrame));
}

/// Of a place so far from the pilot point that is the nearest to it.
bool OutlierFilter::isDirtNear(std::size_t pilot, double distance, bool isAlone) const
{
    return isInSmallGroup_[pilot] ||
           (isAlone && !(reaches_[pilot] > 0 && distance <= reaches_[pilot]));
}

bool OutlierFilter::isAlone(const Point3 &inFrame) const
{
    // One of the others finds itself, another point does not: one more or less of eight is no
    // matter.
    return radius_ > 0 &&
           (!pilotGrid_.hasWithin(inFrame, radius_, neighbours + 1) || strays_.contains(inFrame));
}

} // namespace neuralmesh
