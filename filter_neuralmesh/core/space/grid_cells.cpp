// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/grid_cells.h"

#include <algorithm>
#include <cmath>

namespace neuralmesh {
namespace {

double cellsAlong(double extent, double cellSize)
{
    return std::max(1.0, std::ceil(extent / cellSize));
}

} // namespace

GridCells::GridCells(const Box3 &bounds, std::size_t cellCount)
{
    const Point3 extent = bounds.IsNull() ? Point3(0, 0, 0) : bounds.Dim();
    origin_ = bounds.IsNull() ? Point3(0, 0, 0) : bounds.min;
    // The cell size at which about cellCount cubes fill the bounds, found by bisection because
    // thin bounds hold a single layer.
    const double widest = std::max({extent.X(), extent.Y(), extent.Z(), 1e-30});
    double low = widest / static_cast<double>(cellCount + 1);
    double high = widest;
    constexpr double close = 1.001;
    while (high > close * low) {
        const double middle = std::sqrt(low * high);
        const double cells = cellsAlong(extent.X(), middle) * cellsAlong(extent.Y(), middle) *
                             cellsAlong(extent.Z(), middle);
        (cells > static_cast<double>(cellCount) ? low : high) = middle;
    }
    cellsPerUnit_ = 1 / high;
    x_ = static_cast<int>(cellsAlong(extent.X(), high));
    y_ = static_cast<int>(cellsAlong(extent.Y(), high));
    z_ = static_cast<int>(cellsAlong(extent.Z(), high));
}

} // namespace neuralmesh
