// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of sets of points and numbers that several files need.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/geometry.h"

namespace neuralmesh {

inline Eigen::Vector3d toEigen(const Point3 &p)
{
    return {p.X(), p.Y(), p.Z()};
}
inline Eigen::Vector3d toEigen(const Point &p)
{
    return {p[0], p[1], p[2]};
}

/// The upper median. Requires at least one value.
inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct PrincipalAxes {
    Eigen::Vector3d mean;
    Eigen::Matrix3d axes;      ///< unit columns
    Eigen::Vector3d variances; ///< along the axes, ascending
};

/// Requires at least one point.
PrincipalAxes principalAxes(const std::vector<Point3> &points);
PrincipalAxes principalAxes(const std::vector<Point> &points);

} // namespace neuralmesh
