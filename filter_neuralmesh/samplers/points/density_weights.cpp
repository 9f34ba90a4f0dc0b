// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/density_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/space/plain_points.h"
#include "core/space/spacing_spread.h"

namespace neuralmesh {
namespace {

/// Points at which the spacing is measured.
constexpr std::uint64_t mostPilots = 20000;
/// Of the spacing.
constexpr double exponent = 2.0 / 3;

/// Places where points are, each once, and how often each point's is.
struct Places {
    std::vector<Point3> places;
    std::vector<std::size_t> placeOf; ///< by point
    std::vector<int> copies;          ///< by place
};

Places placesOf(const std::vector<Point3> &points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
    Places found;
    found.placeOf.resize(points.size());
    for (const std::size_t i : order) {
        if (found.places.empty() || found.places.back() != points[i]) {
            found.places.push_back(points[i]);
            found.copies.push_back(0);
        }
        found.placeOf[i] = found.places.size() - 1;
        ++found.copies.back();
    }
    return found;
}

} // namespace

std::vector<double> weightsByDensity(std::uint64_t count,
                                     const std::function<Point(std::uint64_t)> &pointAt)
{
    std::vector<Point3> pilot;
    const std::uint64_t pilots = std::min(count, mostPilots);
    for (std::uint64_t i = 0; i < pilots; ++i)
        pilot.push_back(toVcg(pointAt((2 * i + 1) * count / (2 * pilots))));
    const Places found = placesOf(pilot);
    PointTree tree(found.places);
    std::vector<double> weightOf(found.places.size(), 1);
    if (spacingSpread(found.places, tree).isUneven()) {
        weightOf = tree.usualDistances(neighbourOfSpacing);
        for (double &weight : weightOf)
            weight = std::pow(weight, exponent);
    } else if (found.places.size() == pilot.size()) {
        return {};
    }
    std::vector<double> weights;
    weights.reserve(pilot.size());
    for (const std::size_t place : found.placeOf)
        weights.push_back(weightOf[place] / found.copies[place]);
    return weights;
}

} // namespace neuralmesh
