// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/even_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <vcg/space/index/kdtree/kdtree.h>

#include "core/space/spacing_spread.h"

namespace neuralmesh {
namespace {

/// Points at which the spacing is looked at.
constexpr std::size_t pilots = 4000;

SpacingSpread spacingsOf(std::vector<Point3> distinct)
{
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (distinct.size() <= neighboursOfSpacing)
        return {};
    vcg::KdTree<Scalar> tree(
        vcg::ConstDataWrapper<Point3>(distinct.data(), static_cast<int>(distinct.size())));
    vcg::KdTree<Scalar>::PriorityQueue nearest;
    std::vector<double> spacings;
    const std::size_t step = (distinct.size() - 1) / pilots + 1;
    for (std::size_t i = 0; i < distinct.size(); i += step) {
        tree.doQueryK(distinct[i], neighboursOfSpacing + 1, nearest);
        double squared = 0;
        for (int k = 0; k < nearest.getNofElements(); ++k)
            squared = std::max(squared, static_cast<double>(nearest.getWeight(k)));
        spacings.push_back(std::sqrt(M_PI * squared / neighboursOfSpacing));
    }
    return spreadOf(spacings);
}

} // namespace

std::vector<Point3> withEvenDensity(const std::vector<Point3> &points)
{
    const SpacingSpread spacings = spacingsOf(points);
    if (!spacings.isUneven())
        return points;
    // The first point in each cube of that size stays.
    std::set<std::array<long, 3>> taken;
    std::vector<Point3> kept;
    for (const Point3 &p : points) {
        const std::array<long, 3> cube{std::lround(p.X() / spacings.sparse),
                                       std::lround(p.Y() / spacings.sparse),
                                       std::lround(p.Z() / spacings.sparse)};
        if (taken.insert(cube).second)
            kept.push_back(p);
    }
    return kept;
}

} // namespace neuralmesh
