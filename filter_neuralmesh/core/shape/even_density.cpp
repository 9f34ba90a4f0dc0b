// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/even_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <vcg/space/index/kdtree/kdtree.h>

namespace neuralmesh {
namespace {

/// Neighbours whose disc tells the density, and points at which it is looked at.
constexpr int neighbours = 8;
constexpr std::size_t pilots = 4000;

/// The spacing at the sparse end and at the dense one: of so many in ten pilots each.
constexpr double sparseTenth = 0.9;
constexpr double denseTenth = 0.1;

/// Points are uneven from this ratio of the two: that of a uniform random sample is 1.6.
constexpr double leastRatio = 2;

struct Spacings {
    double dense = 0, sparse = 0;
};

Spacings spacingsOf(std::vector<Point3> distinct)
{
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (distinct.size() <= neighbours)
        return {};
    vcg::KdTree<Scalar> tree(
        vcg::ConstDataWrapper<Point3>(distinct.data(), static_cast<int>(distinct.size())));
    vcg::KdTree<Scalar>::PriorityQueue nearest;
    std::vector<double> spacings;
    const std::size_t step = (distinct.size() - 1) / pilots + 1;
    for (std::size_t i = 0; i < distinct.size(); i += step) {
        tree.doQueryK(distinct[i], neighbours + 1, nearest);
        double squared = 0;
        for (int k = 0; k < nearest.getNofElements(); ++k)
            squared = std::max(squared, static_cast<double>(nearest.getWeight(k)));
        spacings.push_back(std::sqrt(M_PI * squared / neighbours));
    }
    const auto at = [&](double share) {
        const auto place = spacings.begin() + static_cast<std::ptrdiff_t>(
                                                  share * static_cast<double>(spacings.size() - 1));
        std::nth_element(spacings.begin(), place, spacings.end());
        return *place;
    };
    return {at(denseTenth), at(sparseTenth)};
}

} // namespace

std::vector<Point3> withEvenDensity(const std::vector<Point3> &points)
{
    const Spacings spacings = spacingsOf(points);
    if (!(spacings.sparse > leastRatio * spacings.dense))
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
