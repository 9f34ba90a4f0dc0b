// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/space/point_statistics.h"

namespace neuralmesh {

PointTree::PointTree(const std::vector<Point3> &points)
    : points_(points), wrapper_(points.data(), static_cast<int>(points.size())), tree_(wrapper_)
{
}

double PointTree::distance(const Point3 &point, int k)
{
    tree_.doQueryK(point, k + 1, queue_); // the point itself is one
    double furthest = 0;
    for (int i = 0; i < queue_.getNofElements(); ++i)
        furthest = std::max(furthest, static_cast<double>(queue_.getWeight(i)));
    return std::sqrt(furthest); // weights are squared distances
}

std::vector<double> PointTree::distances(int k)
{
    std::vector<double> found;
    found.reserve(points_.size());
    for (const Point3 &point : points_)
        found.push_back(distance(point, k));
    return found;
}

double PointTree::usualDistance(std::size_t index, int k)
{
    std::vector<double> around{distance(points_[index], k)};
    for (const std::size_t other : neighbours(index, k))
        around.push_back(distance(points_[other], k));
    return median(std::move(around));
}

std::vector<double> PointTree::usualDistances(int k)
{
    std::vector<double> distances;
    std::vector<std::size_t> nearest; // of one point after the other, with itself
    std::vector<std::size_t> ends;
    for (const Point3 &point : points_) {
        distances.push_back(distance(point, k)); // what it found is in the queue
        for (int i = 0; i < queue_.getNofElements(); ++i)
            nearest.push_back(static_cast<std::size_t>(queue_.getIndex(i)));
        ends.push_back(nearest.size());
    }
    std::vector<double> usual;
    std::vector<double> around;
    std::size_t next = 0;
    for (const std::size_t end : ends) {
        around.clear();
        for (; next < end; ++next)
            around.push_back(distances[nearest[next]]);
        usual.push_back(median(around));
    }
    return usual;
}

std::vector<std::size_t> PointTree::neighbours(std::size_t index, int k)
{
    tree_.doQueryK(points_[index], k + 1, queue_);
    std::vector<std::size_t> others;
    for (int i = 0; i < queue_.getNofElements(); ++i)
        if (const auto other = static_cast<std::size_t>(queue_.getIndex(i)); other != index)
            others.push_back(other);
    return others;
}

std::vector<bool> PointTree::inSmallGroups(double ratio, int k, double most)
{
    const std::vector<std::size_t> group = groups(ratio, k);
    std::vector<int> sizes(points_.size(), 0);
    for (const std::size_t g : group)
        ++sizes[g];
    std::vector<bool> found;
    found.reserve(group.size());
    for (const std::size_t g : group)
        found.push_back(sizes[g] <= most);
    return found;
}

/// By point: the one that stands for its group.
std::vector<std::size_t> PointTree::groups(double ratio, int k)
{
    std::vector<std::size_t> parent(points_.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    struct Neighbour {
        std::size_t index;
        double squaredDistance;
    };
    std::vector<Neighbour> found; // of one point after the other
    std::vector<std::size_t> ends;
    std::vector<double> reach; // squared
    for (const Point3 &point : points_) {
        tree_.doQueryK(point, k + 1, queue_); // the point itself is one
        reach.push_back(0);
        for (int n = 0; n < queue_.getNofElements(); ++n) {
            const auto squared = static_cast<double>(queue_.getWeight(n));
            found.push_back({static_cast<std::size_t>(queue_.getIndex(n)), squared});
            reach.back() = std::max(reach.back(), squared);
        }
        ends.push_back(found.size());
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
        for (; next < ends[i]; ++next)
            if (found[next].squaredDistance <= ratio * ratio * reach[found[next].index])
                parent[root(found[next].index)] = root(i);
    for (std::size_t i = 0; i < parent.size(); ++i)
        parent[i] = root(i);
    return parent;
}

} // namespace neuralmesh
