// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/two_sides.h"

#include <cmath>

#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// Points around which heights are looked at, and the fewest and the most of them there.
constexpr std::size_t places = 200;
constexpr std::size_t fewestAround = 20;
constexpr std::size_t mostAround = 300;

/// The kurtosis up to which there are two sides. Of plates whose noise has half the standard
/// deviation of the sides' own, 1.8 in the median; of sheets, noisy or clean, 2.3 and more.
constexpr double mostKurtosis = 2.1;

/// Heights up to this share of the radius are rounding, and tell nothing.
constexpr double leastHeight = 1e-5;

std::vector<Point3> pointsAround(const PointIndex &index, const Point3 &place, double radius)
{
    std::vector<Point3> around;
    index.forEachWithin(place, radius, [&](const Point3 &p) { around.push_back(p); });
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

bool haveTwoSides(const PointIndex &index, double radius)
{
    const std::vector<Point3> &points = index.points();
    std::vector<double> kurtoses;
    for (std::size_t i = 0; i < points.size(); i += points.size() / places + 1) {
        const std::vector<Point3> around = pointsAround(index, points[i], radius);
        if (around.size() < fewestAround)
            continue;
        const Eigen::ArrayXd squared = heights(around, radius).array().square();
        const double variance = squared.mean();
        if (std::sqrt(variance) > leastHeight)
            kurtoses.push_back(squared.square().mean() / (variance * variance));
    }
    return !kurtoses.empty() && median(kurtoses) < mostKurtosis;
}

} // namespace neuralmesh
