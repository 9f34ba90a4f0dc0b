// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/space/morton_order.h"
#include "neuralmesh/random.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Points in an order in which those that follow each other are near each other, to be cut into
/// strata: along a Morton curve or, of very many, as they come, which for most scans is much the
/// same.
class OrderOfPoints {
public:
    OrderOfPoints() = default;
    /// pointAt(i) gives the points, which lie in the bounds; it is not kept.
    OrderOfPoints(std::uint64_t count, const Box &bounds,
                  const std::function<Point(std::size_t)> &pointAt)
        : count_(count)
    {
        if (count <= mostOrdered)
            order_ = MortonOrder(bounds).indices(static_cast<std::size_t>(count), pointAt);
    }

    /// Index of a point of a stratum, of so many of equal length: each point is as likely as any
    /// other, and where there are as many strata as points, each is drawn once.
    std::uint64_t draw(Random &random, std::size_t stratum, std::size_t strata) const
    {
        const double length = static_cast<double>(count_) / static_cast<double>(strata);
        const double place = (static_cast<double>(stratum) + random.unit()) * length;
        const std::uint64_t index = std::min(static_cast<std::uint64_t>(place), count_ - 1);
        return order_.empty() ? index : order_[static_cast<std::size_t>(index)];
    }

private:
    /// 16 MB of indices.
    static constexpr std::uint64_t mostOrdered = std::uint64_t(1) << 22;

    std::uint64_t count_ = 0;
    std::vector<std::uint32_t> order_;
};

} // namespace neuralmesh
