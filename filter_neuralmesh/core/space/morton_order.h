// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/geometry.h"

namespace neuralmesh {

/// Sorts points along a Morton (Z-order) curve over the bounds, so that points which follow each
/// other are near each other: what a batch of samples touches stays in cache, and one winner is a
/// good guess for the next. Points with the same key keep their order.
class MortonOrder {
public:
    explicit MortonOrder(const Box &bounds);
    /// `points` in that order, into `sorted`.
    void sort(const std::vector<Point> &points, std::vector<Point3> &sorted);

    /// Indices of so many points in that order, as far as cells tell them apart that are about as
    /// many as the points, and no more than memory has room for beside these. pointAt(i) gives the
    /// points, each twice.
    std::vector<std::uint32_t> indices(std::size_t count,
                                       const std::function<Point(std::size_t)> &pointAt) const;

private:
    std::uint32_t key(const Point &point) const;
    void sortByKey();

    Point origin_;
    Scalar cellsPerUnit_;
    std::vector<std::uint64_t> keyed_; ///< key and place of each point, scratch
    std::vector<std::uint64_t> moved_; ///< scratch
};

} // namespace neuralmesh
