// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/input_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/space/point_statistics.h"
#include "neuralmesh/sampler_errors.h"

namespace neuralmesh {
namespace {

/// Extent, as a share of the diagonal, below which points count as lying on a plane or a line:
/// above the rounding of single-precision input, below any real relief.
constexpr double flatExtent = 1e-6;

/// Widths of the points along their principal axes, ascending, in units of the diagonal.
template <class AnyPoint> Eigen::Vector3d principalWidths(const std::vector<AnyPoint> &points)
{
    const PrincipalAxes frame = principalAxes(points);
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;
    for (const AnyPoint &p : points) {
        const Eigen::Vector3d along = frame.axes.transpose() * (toEigen(p) - frame.mean);
        low = low.cwiseMin(along);
        high = high.cwiseMax(along);
    }
    return high - low;
}

bool isFlatBy(const Eigen::Vector3d &widths, std::uint64_t ignored)
{
    if (widths[1] < flatExtent)
        throw InvalidInput(allPointsBut(ignored) +
                           " lie on a line: there is no surface to reconstruct.");
    return widths[0] < flatExtent;
}

} // namespace

void refuseNotFinite(std::uint64_t notFinite, std::uint64_t points, std::uint64_t first)
{
    throw InvalidInput(std::to_string(notFinite) + " of " + std::to_string(points) +
                       " points have coordinates that are NaN or infinite (the first is point " +
                       std::to_string(first) + "). Remove them and try again.");
}

void requireFinite(const std::vector<Point> &world)
{
    std::size_t broken = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < world.size(); ++i)
        if (!isFinite(world[i]) && broken++ == 0)
            first = i;
    if (broken > 0)
        refuseNotFinite(broken, world.size(), first);
}

UnitFrame frameOf(const vcg::Box3d &worldBounds)
{
    if (!std::isfinite(worldBounds.Diag()))
        throw InvalidInput("The points' coordinates are too large: their bounding box's diagonal "
                           "is not finite.");
    if (!(worldBounds.Diag() > 0))
        throw InvalidInput("All points lie in one place: there is no surface to reconstruct.");
    return UnitFrame(toPlain(worldBounds));
}

void requireRange(char variable, Range range)
{
    if (!std::isfinite(range.high - range.low))
        throw EmptyRange(variable, true);
    if (!(range.low < range.high))
        throw EmptyRange(variable);
}

void requireFourPoints(std::size_t distinct)
{
    if (distinct < 4)
        throw InvalidInput("Only " + std::to_string(distinct) +
                           " distinct points: a closed surface needs at least 4.");
}

bool isFlat(const std::vector<Point3> &points, std::uint64_t ignored)
{
    return isFlatBy(principalWidths(points), ignored);
}

bool isFlat(const std::vector<Point> &points, std::uint64_t ignored)
{
    return isFlatBy(principalWidths(points), ignored);
}

std::vector<double> densityShares(std::vector<double> density, std::size_t points)
{
    using Problem = InvalidDensity::Problem;
    if (density.empty())
        return density;
    if (density.size() != points)
        throw InvalidDensity(Problem::wrongCount, density.size());
    std::size_t broken = 0;
    std::size_t first = 0;
    double largest = 0;
    for (std::size_t i = 0; i < density.size(); ++i) {
        if (!(density[i] >= 0 && std::isfinite(density[i])) && broken++ == 0)
            first = i;
        largest = std::max(largest, density[i]);
    }
    if (broken > 0)
        throw InvalidDensity(Problem::notValid, density.size(), broken, first);
    if (!(largest > 0))
        throw InvalidDensity(Problem::allZero, density.size());
    for (double &value : density)
        value /= largest;
    return density;
}

} // namespace neuralmesh
