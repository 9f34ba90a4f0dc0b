// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/spacing_spread.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Points whose spacing is measured.
constexpr std::size_t measuredPoints = 1000;
/// Of the points at the dense end, and of the surface at the sparse one.
constexpr double tenth = 0.1;
/// Of the points, those beyond the sparse end at the least: fewer tell no surface, and of heavy
/// tails the last few have all of it.
constexpr double leastOfPoints = 0.01;
/// Points are uneven from this ratio of the two: that of a uniform random sample of a square is 1.6
/// to 1.8, of 500 points up to 2.0.
constexpr double leastRatio = 2;

/// What a point stands for of the surface, but for a factor.
double areaOf(double spacing)
{
    return spacing * spacing;
}

SpacingSpread spreadOf(std::vector<double> spacings)
{
    std::sort(spacings.begin(), spacings.end());
    double area = 0;
    for (const double spacing : spacings)
        area += areaOf(spacing);
    std::size_t sparse = spacings.size() - 1;
    double above = areaOf(spacings[sparse]);
    const auto most = static_cast<std::size_t>((1 - leastOfPoints) * static_cast<double>(sparse));
    while (sparse > 0 && (above < tenth * area || sparse > most))
        above += areaOf(spacings[--sparse]);
    const auto dense = static_cast<std::size_t>(tenth * static_cast<double>(spacings.size() - 1));
    return {spacings[dense], spacings[sparse]};
}

template <class SpacingAt> SpacingSpread spreadBy(std::size_t points, const SpacingAt &spacingAt)
{
    const std::size_t count = std::min(points, measuredPoints);
    std::vector<double> spacings;
    spacings.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        spacings.push_back(spacingAt(i * points / count));
    return spreadOf(std::move(spacings));
}

} // namespace

bool SpacingSpread::isUneven() const
{
    return sparse > leastRatio * dense;
}

SpacingSpread spacingSpread(const std::vector<Point3> &distinct, PointTree &tree)
{
    const SpacingSpread found = spreadBy(distinct.size(), [&](std::size_t i) {
        return tree.distance(distinct[i], neighbourOfSpacing);
    });
    if (!found.isUneven())
        return found;
    return spreadBy(distinct.size(),
                    [&](std::size_t i) { return tree.usualDistance(i, neighbourOfSpacing); });
}

} // namespace neuralmesh
