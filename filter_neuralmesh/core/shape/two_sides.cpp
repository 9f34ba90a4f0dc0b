// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/two_sides.h"

#include <algorithm>
#include <cmath>

#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// Points around which heights are looked at, and the fewest and the most of them there.
constexpr std::size_t places = 200;
constexpr std::size_t fewestAround = 20;
constexpr std::size_t mostAround = 300;

/// The ratio of the mean deviation to the standard deviation, above which heights have two peaks:
/// of all symmetric distributions with one, the uniform has the greatest, √3/2 = 0.866 (Geary 1935
/// takes it for a test of normality). Of sides ±1 with noise of half that, 0.893.
constexpr double mostOfOnePeak = 0.87;

/// Sides that are no further apart than so many spacings of all points are not told apart by their
/// surface: each point has neighbours of the other side as near as those of its own.
constexpr double thinnestInSpacings = 2;

std::vector<Point3> pointsAround(const PointIndex &index, const Point3 &place, double radius)
{
    std::vector<Point3> around;
    index.forEachWithin(place, radius, [&](const Point3 &p) { around.push_back(p); });
    return around;
}

std::vector<Point3> fewOf(const std::vector<Point3> &around)
{
    const std::size_t stride = around.size() / mostAround + 1;
    std::vector<Point3> chosen;
    for (std::size_t i = 0; i < around.size(); i += stride)
        chosen.push_back(around[i]);
    return chosen;
}

/// Above the best quadric, in radii.
Eigen::VectorXd heights(const std::vector<Point3> &around, double radius)
{
    const PrincipalAxes frame = principalAxes(around);
    const auto count = static_cast<Eigen::Index>(around.size());
    Eigen::MatrixXd terms(count, 6);
    Eigen::VectorXd height(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector3d p = frame.axes.transpose() *
                                  (toEigen(around[static_cast<std::size_t>(i)]) - frame.mean) /
                                  radius;
        const double x = p[1];
        const double y = p[2];
        height[i] = p[0];
        terms.row(i) << 1, x, y, x * x, x * y, y * y;
    }
    const Eigen::VectorXd quadric = terms.colPivHouseholderQr().solve(height);
    return height - terms * quadric;
}

} // namespace

bool haveTwoSides(const PointIndex &index, double radius, double leastThickness)
{
    const std::vector<Point3> &points = index.points();
    std::vector<double> ratios;
    for (std::size_t i = 0; i < points.size(); i += points.size() / places + 1) {
        const std::vector<Point3> around = pointsAround(index, points[i], radius);
        if (around.size() < fewestAround)
            continue;
        const Eigen::ArrayXd deviations = heights(fewOf(around), radius).array().abs();
        const double standard = std::sqrt(deviations.square().mean());
        const double spacing = radius * std::sqrt(M_PI / static_cast<double>(around.size()));
        const bool isThick =
            2 * standard * radius >= std::max(leastThickness, thinnestInSpacings * spacing);
        ratios.push_back(isThick ? deviations.mean() / standard : 0);
    }
    return !ratios.empty() && median(ratios) > mostOfOnePeak;
}

} // namespace neuralmesh
