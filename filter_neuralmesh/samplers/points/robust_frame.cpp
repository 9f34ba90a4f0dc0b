// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/robust_frame.h"

#include <algorithm>
#include <cmath>

namespace neuralmesh {
namespace {

/// From here on, in units of the frame, distances grow with the logarithm.
constexpr Scalar farAway = 1e6;

Scalar greatestCoordinate(const Point3 &place)
{
    return std::max({std::abs(place.X()), std::abs(place.Y()), std::abs(place.Z())});
}

Scalar quantile(std::vector<Scalar> &values, double share)
{
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

} // namespace

RobustFrame::RobustFrame(const std::vector<Point3> &points)
{
    Scalar middleHalf = 0;
    Scalar all = 0;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Scalar> values;
        values.reserve(points.size());
        for (const Point3 &point : points)
            values.push_back(point[axis]);
        const Scalar low = quantile(values, 0.25);
        const Scalar high = quantile(values, 0.75);
        middle_[axis] = low / 2 + high / 2;
        middleHalf = std::max(middleHalf, high / 2 - low / 2);
        all = std::max(all, quantile(values, 1) / 2 - quantile(values, 0) / 2);
    }
    // Where half of the points have the same coordinates, the others are the data.
    unit_ = middleHalf > 0 ? middleHalf : all > 0 ? all : 1;
}

Point3 RobustFrame::toFrame(const Point3 &point) const
{
    // In halves: the difference of the largest numbers that there are is no number.
    const Point3 half = point / 2 - middle_ / 2;
    const Scalar along = greatestCoordinate(half);
    const Scalar distance = std::min(2 * (along / unit_), 1e300);
    if (distance <= farAway)
        return half / unit_ * 2;
    return half / along * (farAway * (1 + std::log(distance / farAway)));
}

bool RobustFrame::isFarAway(const Point3 &inFrame)
{
    return greatestCoordinate(inFrame) > farAway;
}

} // namespace neuralmesh
