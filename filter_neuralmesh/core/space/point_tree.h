// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <vcg/space/index/kdtree/kdtree.h>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Points with a search tree, and what the k nearest neighbours of each tell of it. The points have
/// to outlive the tree.
class PointTree {
public:
    explicit PointTree(const std::vector<Point3> &points);

    /// Distance to the k-th neighbour of one of the points.
    double distance(const Point3 &point, int k);

    /// The same for all of them.
    std::vector<double> distances(int k);

    /// The median of the distances of a point and of its k nearest neighbours to their k-th: that
    /// of a stray is the one of those that it is near to.
    double usualDistance(std::size_t index, int k);

    /// The same for all of them.
    std::vector<double> usualDistances(int k);

    /// The k nearest others of a point.
    std::vector<std::size_t> neighbours(std::size_t index, int k);

    /// By point: whether its group has at most so many points. Two of the k nearest neighbours
    /// belong together where they are no further from each other than `ratio` times the distance of
    /// either to its k-th neighbour, whatever the density; and all that do so by way of others.
    std::vector<bool> inSmallGroups(double ratio, int k, double most);

private:
    std::vector<std::size_t> groups(double ratio, int k);

    const std::vector<Point3> &points_;
    vcg::ConstDataWrapper<Point3> wrapper_;
    vcg::KdTree<Scalar> tree_;
    vcg::KdTree<Scalar>::PriorityQueue queue_;
};

} // namespace neuralmesh
