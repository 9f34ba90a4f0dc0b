// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/even_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/space/spacing_spread.h"

namespace neuralmesh {
namespace {

/// The side of the square that a point stands for, by the distance to that neighbour of it: the
/// disc up to there has the area of so many.
const double sideOfDistance = std::sqrt(M_PI / neighbourOfSpacing);

std::vector<Point3> sortedPlaces(std::vector<Point3> points)
{
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

} // namespace

std::vector<Point3> withEvenDensity(const std::vector<Point3> &points)
{
    const std::vector<Point3> places = sortedPlaces(points);
    if (places.size() <= neighbourOfSpacing)
        return points;
    PointTree tree(places);
    const SpacingSpread spacings = spacingSpread(places, tree);
    if (!spacings.isUneven())
        return points;
    const double side = sideOfDistance * spacings.sparse;
    // The first point in each cube of that size stays.
    std::set<std::array<long, 3>> taken;
    std::vector<Point3> kept;
    for (const Point3 &p : points) {
        const std::array<long, 3> cube{std::lround(p.X() / side), std::lround(p.Y() / side),
                                       std::lround(p.Z() / side)};
        if (taken.insert(cube).second)
            kept.push_back(p);
    }
    return kept;
}

} // namespace neuralmesh
