// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/grid_frame.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Room between the points and the border of the grid, in extents of the points.
constexpr double margin = 0.15;

/// The shortest side of the grid, in its longest: a border nearby would press on the field.
constexpr double leastSide = 0.75;

} // namespace

GridFrame::GridFrame(const std::vector<Point3> &points, int firstCells)
{
    Box3 bounds;
    for (const Point3 &p : points)
        bounds.Add(p);
    const double extent = std::max({bounds.DimX(), bounds.DimY(), bounds.DimZ()});
    side_ = extent * (1 + 2 * margin);
    int *cells[3] = {&size_.x, &size_.y, &size_.z};
    for (int axis = 0; axis < 3; ++axis) {
        const double needed =
            std::max(leastSide, (bounds.Dim()[axis] / extent + 2 * margin) / (1 + 2 * margin));
        *cells[axis] =
            cellsTogether * static_cast<int>(std::ceil(needed * firstCells / cellsTogether - 1e-9));
        corner_[axis] = bounds.Center()[axis] - side_ * *cells[axis] / firstCells / 2;
    }
}

} // namespace neuralmesh
