// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "core/shape/grid.h"

namespace neuralmesh {

/// The box of the grid: the points with room around, its longest side 1 long.
class GridFrame {
public:
    /// Cells of the first grid along an axis are a multiple of this, so that coarser grids follow.
    static constexpr int cellsTogether = 4;

    /// `firstCells` are those of the first grid along the longest side.
    GridFrame(const std::vector<Point3> &points, int firstCells);

    /// Whether the points have any extent.
    bool isProper() const { return side_ > 0; }
    /// Of the first grid.
    const GridSize &size() const { return size_; }
    Point3 toGrid(const Point3 &p) const { return (p - corner_) / side_; }
    /// In the grid's box, of a hole as wide as that in the unit frame.
    double areaOfHole(double width) const { return M_PI / 4 * width * width / (side_ * side_); }
    Point3 fromGrid(const Point3 &p) const { return p * side_ + corner_; }

private:
    Point3 corner_;
    double side_ = 1;
    GridSize size_;
};

} // namespace neuralmesh
