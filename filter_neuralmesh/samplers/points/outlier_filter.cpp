// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/outlier_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <vcg/space/index/kdtree/kdtree.h>

#include "core/space/point_statistics.h"
#include "samplers/points/distinct_points.h"

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
/// Neighbours by which a surface is told from a cloud, and the surface variation up to which it is
/// one. Nine points at random in space have 0.118 in the median, on a sphere of 400 points 0.003.
constexpr int surfaceNeighbours = 8;
constexpr double mostSurfaceVariation = 0.02;
/// Pilot points of a group apart from all others that is no part of the data, as a share of all, up
/// to which its points are outliers: a mesh of 5,000 vertices would have a dozen for it.
constexpr double mostOfGroup = 0.0025;
/// Above this share of the places there are no outliers.
constexpr double mostOutliers = 0.2;

/// Every n-th point, as many as asked for or all.
std::vector<Point3> thinned(const std::vector<Point3> &points, std::size_t count)
{
    if (points.size() <= count)
        return points;
    std::vector<Point3> chosen;
    chosen.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(points[i * points.size() / count]);
    return chosen;
}

/// The pilot points with a search tree.
class PilotTree {
public:
    explicit PilotTree(const std::vector<Point3> &pilot)
        : pilot_(pilot), wrapper_(pilot.data(), static_cast<int>(pilot.size())), tree_(wrapper_)
    {
    }

    /// Distance to the k-th neighbour of a pilot point.
    double distance(const Point3 &point, int k)
    {
        tree_.doQueryK(point, k + 1, queue_); // the point itself is one
        double furthest = 0;
        for (int i = 0; i < queue_.getNofElements(); ++i)
            furthest = std::max(furthest, static_cast<double>(queue_.getWeight(i)));
        return std::sqrt(furthest); // weights are squared distances
    }

    std::vector<double> distances(int k)
    {
        std::vector<double> found;
        found.reserve(pilot_.size());
        for (const Point3 &point : pilot_)
            found.push_back(distance(point, k));
        return found;
    }

    /// Whether a pilot point is off the plane of its k neighbours, and far from them as they are
    /// from theirs.
    bool strays(std::size_t index, const std::vector<double> &distances, int k)
    {
        const Point3 &point = pilot_[index];
        tree_.doQueryK(point, k + 1, queue_);
        std::vector<std::size_t> others;
        std::vector<double> theirs;
        for (int i = 0; i < queue_.getNofElements(); ++i) {
            const auto other = static_cast<std::size_t>(queue_.getIndex(i));
            if (other == index)
                continue;
            others.push_back(other);
            theirs.push_back(distances[other]);
        }
        const double usual = median(std::move(theirs));
        if (distances[index] <= strayRatio * usual)
            return false;
        std::vector<Point3> around;
        for (const std::size_t other : others)
            if (distances[other] <= strayRatio * usual) // no stray itself
                around.push_back(pilot_[other]);
        const PrincipalAxes frame = principalAxes(around);
        const double height = std::abs(frame.axes.col(0).dot(toEigen(point) - frame.mean));
        return height > strayHeight * distances[index];
    }

    /// By pilot point: the one that stands for its group. Two of the k nearest neighbours belong
    /// together where they are no further from each other than `ratio` times the distance of either
    /// to its k-th neighbour, whatever the density; and all that do so by way of others.
    std::vector<std::size_t> groups(double ratio, int k)
    {
        std::vector<std::size_t> parent(pilot_.size());
        std::iota(parent.begin(), parent.end(), std::size_t(0));
        const auto root = [&](std::size_t i) {
            while (parent[i] != i)
                i = parent[i] = parent[parent[i]];
            return i;
        };
        const std::vector<double> reach = distances(k);
        for (std::size_t i = 0; i < pilot_.size(); ++i) {
            tree_.doQueryK(pilot_[i], k + 1, queue_);
            for (int n = 0; n < queue_.getNofElements(); ++n) {
                const auto other = static_cast<std::size_t>(queue_.getIndex(n));
                if (std::sqrt(queue_.getWeight(n)) <= ratio * reach[other])
                    parent[root(other)] = root(i);
            }
        }
        for (std::size_t i = 0; i < parent.size(); ++i)
            parent[i] = root(i);
        return parent;
    }

    /// Surface variation (Pauly 2002) of a point and its k neighbours: the least eigenvalue's share
    /// of their covariance's trace. Zero on a plane, 1/3 at the most.
    double surfaceVariation(const Point3 &point, int k)
    {
        tree_.doQueryK(point, k + 1, queue_);
        const int count = queue_.getNofElements();
        std::vector<Point3> around;
        for (int i = 0; i < count; ++i)
            around.push_back(pilot_[static_cast<std::size_t>(queue_.getIndex(i))]);
        const Eigen::Vector3d variances = principalAxes(around).variances;
        return variances.sum() > 0 ? variances[0] / variances.sum() : 0;
    }

private:
    const std::vector<Point3> &pilot_;
    vcg::ConstDataWrapper<Point3> wrapper_;
    vcg::KdTree<Scalar> tree_;
    vcg::KdTree<Scalar>::PriorityQueue queue_;
};

double measureRadius(PilotTree &tree, const std::vector<Point3> &pilot)
{
    std::vector<double> logarithms;
    for (const Point3 &point : thinned(pilot, measuredPoints))
        if (const double distance = tree.distance(point, neighbours); distance > 0)
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

std::vector<Point3> straysAmong(const std::vector<Point3> &pilot, PilotTree &tree)
{
    const std::vector<double> distances = tree.distances(neighbours);
    std::vector<Point3> strays;
    for (std::size_t i = 0; i < pilot.size(); ++i)
        if (tree.strays(i, distances, neighbours))
            strays.push_back(pilot[i]);
    return strays;
}

/// By pilot point: whether its group is too small for a part of the data.
std::vector<bool> inSmallGroups(std::size_t points, PilotTree &tree)
{
    const std::vector<std::size_t> group = tree.groups(leastRatio, neighbours);
    std::vector<int> sizes(points, 0);
    for (const std::size_t g : group)
        ++sizes[g];
    const double most = mostOfGroup * static_cast<double>(points);
    std::vector<bool> found;
    found.reserve(points);
    for (const std::size_t g : group)
        found.push_back(sizes[g] <= most);
    return found;
}

/// Whether points that stand alone lie on surfaces of their own all the same, only sparser ones.
bool lieOnSurfaces(const std::vector<Point3> &alone)
{
    if (alone.size() <= surfaceNeighbours)
        return false;
    PilotTree tree(alone);
    std::vector<double> variations;
    for (const Point3 &point : thinned(alone, measuredPoints))
        variations.push_back(tree.surfaceVariation(point, surfaceNeighbours));
    return median(variations) < mostSurfaceVariation;
}

} // namespace

OutlierFilter::OutlierFilter(const std::vector<Point3> &points, const Box3 &bounds)
    : pilotGrid_(bounds)
{
    if (points.size() < leastPoints)
        return;
    const std::vector<Point3> drawn = thinned(points, pilotPoints);
    const std::vector<Point3> pilot = withoutRepetitions(drawn);
    insert(pilot);
    PilotTree tree(pilot);
    radius_ = measureRadius(tree, pilot);
    if (drawn.size() == points.size())
        for (const Point3 &point : straysAmong(pilot, tree))
            strays_.insert(point);
    isInSmallGroup_ = inSmallGroups(pilot.size(), tree);
    const Scalar reach = radius_;
    judgeThoseAlone(pilot);
    std::size_t places = 0;
    for (std::size_t i = 0; i < pilot.size(); ++i)
        if (isInSmallGroup_[i] || isAlone(pilot[i]))
            ++places;
        else
            bounds_.Add(pilot[i]);
    if (static_cast<double>(places) > mostOutliers * static_cast<double>(pilot.size()))
        return;
    bounds_.Offset(reach);
    pilotGrid_ = VertexGrid(bounds_);
    insert(pilot);
    const auto dirt = std::count_if(drawn.begin(), drawn.end(),
                                    [&](const Point3 &point) { return isDirt(point); });
    share_ = static_cast<double>(dirt) / static_cast<double>(drawn.size());
}

void OutlierFilter::insert(const std::vector<Point3> &pilot)
{
    for (std::size_t i = 0; i < pilot.size(); ++i)
        pilotGrid_.insert(static_cast<VertexId>(i), pilot[i]);
}

/// Where those alone, but for small groups, lie on surfaces, standing alone says nothing.
void OutlierFilter::judgeThoseAlone(const std::vector<Point3> &pilot)
{
    std::vector<Point3> alone;
    for (std::size_t i = 0; i < pilot.size(); ++i)
        if (!isInSmallGroup_[i] && isAlone(pilot[i]))
            alone.push_back(pilot[i]);
    if (!lieOnSurfaces(alone))
        return;
    radius_ = 0;
}

bool OutlierFilter::isDirt(const Point3 &point) const
{
    return isInSmallGroup_[pilotGrid_.nearest(point)] || isAlone(point);
}

bool OutlierFilter::isAlone(const Point3 &point) const
{
    // A pilot point finds itself, another point does not: one more or less of eight is no matter.
    return radius_ > 0 &&
           (!pilotGrid_.hasWithin(point, radius_, neighbours + 1) || strays_.contains(point));
}

} // namespace neuralmesh
