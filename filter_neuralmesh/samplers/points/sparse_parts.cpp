// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/sparse_parts.h"

#include <algorithm>
#include <numeric>

#include "core/space/point_statistics.h"
#include "core/space/point_tree.h"

namespace neuralmesh {
namespace {

/// Neighbours by whose directions a surface or a wire is told from strays.
constexpr int directions = 8;
/// Variance of these off a plane, by that across it, up to which they are of a surface; and the
/// same of a wire. Eight directions at random have 0.4 in the median, on a sphere of 400 points
/// 0.02.
constexpr double mostFlatness = 0.1;
/// A neighbour is at the spacing of a point where its own is not smaller by more than this factor;
/// and others of a part are no further from a point than so many times its spacing.
constexpr double mostSpacingRatio = 2.5;
/// Points have one spacing up to this factor: the standard deviation of that of random points on a
/// surface is 18 %.
constexpr double likeSpacing = 1.5;

/// Whether the neighbours of a point are in a plane with it, or in a line.
bool hasSurroundings(const std::vector<Point3> &points, std::size_t index,
                     const std::vector<std::size_t> &neighbours)
{
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::size_t other : neighbours) {
        const Eigen::Vector3d towards = toEigen(points[other] - points[index]).normalized();
        spread += towards * towards.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d &variances = axes.eigenvalues(); // ascending
    return variances[0] <= mostFlatness * variances[1] ||
           variances[1] <= mostFlatness * variances[2];
}

/// Whether at least two neighbours are no closer to theirs than this point is to its own: what
/// looks at others from outside has none, and sees them in one direction, as in a line.
bool isAtSpacingOf(const std::vector<std::size_t> &neighbours, std::size_t index,
                   const std::vector<double> &distances)
{
    return std::count_if(neighbours.begin(), neighbours.end(), [&](std::size_t other) {
               return distances[index] <= mostSpacingRatio * distances[other];
           }) >= 2;
}

using Neighbourhoods = std::vector<std::vector<std::size_t>>;

/// By point: whether most of it and its neighbours are so.
std::vector<bool> majorities(const std::vector<bool> &are, const Neighbourhoods &neighbours)
{
    std::vector<bool> found;
    for (std::size_t i = 0; i < are.size(); ++i) {
        const auto others = std::count_if(neighbours[i].begin(), neighbours[i].end(),
                                          [&](std::size_t other) { return are[other]; });
        found.push_back(2 * (others + (are[i] ? 1 : 0)) > directions + 1);
    }
    return found;
}

/// By point: whether it lies in a sparser part. Chance makes strays look like one, which their
/// neighbours outvote.
std::vector<bool> inParts(const std::vector<Point3> &sparse, PointTree &tree,
                          const std::vector<double> &distances)
{
    Neighbourhoods neighbours;
    std::vector<bool> are;
    for (std::size_t i = 0; i < sparse.size(); ++i) {
        neighbours.push_back(tree.neighbours(i, directions));
        are.push_back(isAtSpacingOf(neighbours[i], i, distances) &&
                      hasSurroundings(sparse, i, neighbours[i]));
    }
    return majorities(are, neighbours);
}

/// By point: whether it is in a part, or most points at its spacing are.
std::vector<bool> withSpacingOfParts(const std::vector<bool> &areInParts,
                                     const std::vector<double> &distances)
{
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
    std::vector<bool> found = areInParts;
    std::size_t first = 0, last = 0; // those at the spacing of a point, and the one after them
    std::size_t inParts = 0;         // how many of these are
    for (const std::size_t i : order) {
        for (; last < order.size() && distances[order[last]] <= likeSpacing * distances[i]; ++last)
            inParts += areInParts[order[last]] ? 1 : 0;
        for (; likeSpacing * distances[order[first]] < distances[i]; ++first)
            inParts -= areInParts[order[first]] ? 1 : 0;
        found[i] = found[i] || 2 * inParts > last - first;
    }
    return found;
}

} // namespace

std::vector<double> reachesInSparseParts(const std::vector<Point3> &sparse)
{
    std::vector<double> reaches(sparse.size(), 0);
    if (sparse.size() <= directions)
        return reaches;
    PointTree tree(sparse);
    const std::vector<double> distances = tree.distances(directions);
    const std::vector<bool> areInParts =
        withSpacingOfParts(inParts(sparse, tree, distances), distances);
    for (std::size_t i = 0; i < sparse.size(); ++i)
        if (areInParts[i])
            reaches[i] = mostSpacingRatio * distances[i];
    return reaches;
}

} // namespace neuralmesh
