// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/two_sides.h"

#include <algorithm>
#include <cmath>

#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// Points around which heights are looked at, and the fewest and the most of them there.
constexpr std::size_t places = 100;
constexpr std::size_t fewestAround = 20;
constexpr std::size_t mostAround = 300;

/// The ratio of the mean deviation to the standard deviation, above which heights have two peaks:
/// of all symmetric distributions with one, the uniform has the greatest, √3/2 = 0.866 (Geary 1935
/// takes it for a test of normality). Of sides ±1 with noise of half that, 0.893.
constexpr double mostOfOnePeak = 0.87;

/// Sides that are no further apart than so many spacings of all points are not told apart by their
/// surface: each point has neighbours of the other side as near as those of its own.
constexpr double thinnestInSpacings = 2;

/// Of heights.
class Peaks {
public:
    explicit Peaks(const Eigen::ArrayXd &heights) : mean_(heights.mean())
    {
        const Eigen::ArrayXd deviations = (heights - mean_).abs();
        deviation_ = deviations.mean();
        standard_ = std::sqrt(deviations.square().mean());
    }

    /// Between the two.
    double mean() const { return mean_; }

    /// Whether there are two of them, at the least so far apart. The heights are those of `count`
    /// points in the radius.
    bool areTwo(std::size_t count, double radius, double leastThickness) const
    {
        const double spacing = radius * std::sqrt(M_PI / static_cast<double>(count));
        return 2 * standard_ >= std::max(leastThickness, thinnestInSpacings * spacing) &&
               deviation_ > mostOfOnePeak * standard_;
    }

private:
    double mean_, deviation_, standard_;
};

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

/// Above the best quadric.
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
    return (height - terms * quadric) * radius;
}

} // namespace

bool haveTwoSides(const PointIndex &index, double radius, double leastThickness)
{
    const std::vector<Point3> &points = index.points();
    std::size_t looked = 0;
    std::size_t walls = 0;
    for (std::size_t i = 0; i < points.size(); i += points.size() / places + 1) {
        const std::vector<Point3> around = pointsAround(index, points[i], radius);
        if (around.size() < fewestAround)
            continue;
        ++looked;
        if (Peaks(heights(fewOf(around), radius)).areTwo(around.size(), radius, leastThickness))
            ++walls;
        else if (2 * (looked - walls) > places)
            return false;
    }
    return 2 * walls > looked;
}

InnerSides::InnerSides(const std::vector<Point3> &points, const std::vector<vcg::Point3f> &normals,
                       double radius, double leastThickness)
    : index_(points), normals_(normals), radius_(radius), leastThickness_(leastThickness)
{
}

bool InnerSides::hasPoint(std::size_t index) const
{
    const Point3 &point = index_.points()[index];
    const Point3 normal = Point3::Construct(normals_[index]).Normalize();
    std::vector<std::size_t> around;
    std::vector<double> heights;
    index_.forEachIndexWithin(point, radius_, [&](std::size_t other) {
        around.push_back(other);
        heights.push_back((index_.points()[other] - point) * normal);
    });
    if (around.size() < fewestAround)
        return false;
    const Peaks peaks(Eigen::Map<const Eigen::ArrayXd>(heights.data(),
                                                       static_cast<Eigen::Index>(heights.size())));
    if (peaks.mean() <= 0 || !peaks.areTwo(around.size(), radius_, leastThickness_))
        return false;
    double agreement = 0;
    for (std::size_t k = 0; k < around.size(); ++k)
        if (heights[k] > peaks.mean())
            agreement += normal * Point3::Construct(normals_[around[k]]).Normalize();
    return agreement > 0;
}

} // namespace neuralmesh
