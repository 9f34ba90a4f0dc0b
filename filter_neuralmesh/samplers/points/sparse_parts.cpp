// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/sparse_parts.h"

#include <algorithm>

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
/// A neighbour is at the spacing of a point where its own is not smaller by more than this factor.
constexpr double mostSpacingRatio = 2.5;

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

/// Whether at least two neighbours are no closer to theirs than this point is to its own: a stray
/// that looks at a part from outside has none.
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

/// By point: whether it lies in a sparser part. Chance makes patches of strays look like one, which
/// neighbours of neighbours outvote.
std::vector<bool> inParts(const std::vector<Point3> &alone, PointTree &tree,
                          const std::vector<double> &distances)
{
    Neighbourhoods neighbours;
    std::vector<bool> are;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        neighbours.push_back(tree.neighbours(i, directions));
        are.push_back(hasSurroundings(alone, i, neighbours[i]));
    }
    are = majorities(majorities(are, neighbours), neighbours);
    for (std::size_t i = 0; i < alone.size(); ++i)
        are[i] = are[i] && isAtSpacingOf(neighbours[i], i, distances);
    return are;
}

} // namespace

std::vector<double> reachesInSparseParts(const std::vector<Point3> &alone, PointTree &all)
{
    std::vector<double> reaches(alone.size(), 0);
    if (alone.size() <= directions)
        return reaches;
    PointTree tree(alone);
    const std::vector<bool> isInPart = inParts(alone, tree, tree.distances(directions));
    for (std::size_t i = 0; i < alone.size(); ++i)
        if (isInPart[i])
            reaches[i] = mostSpacingRatio * all.distance(alone[i], directions);
    return reaches;
}

} // namespace neuralmesh
