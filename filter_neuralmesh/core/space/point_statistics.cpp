// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

template <class AnyPoint> PrincipalAxes axesOf(const std::vector<AnyPoint> &points)
{
    const auto count = static_cast<double>(points.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const AnyPoint &p : points)
        mean += toEigen(p) / count;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const AnyPoint &p : points)
        covariance += (toEigen(p) - mean) * (toEigen(p) - mean).transpose() / count;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(covariance);
    // Rounding can make a variance of nothing negative.
    return {mean, principal.eigenvectors(), principal.eigenvalues().cwiseMax(0.0)};
}

} // namespace

PrincipalAxes principalAxes(const std::vector<Point3> &points)
{
    return axesOf(points);
}

PrincipalAxes principalAxes(const std::vector<Point> &points)
{
    return axesOf(points);
}

} // namespace neuralmesh
