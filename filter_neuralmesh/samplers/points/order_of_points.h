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
/// strata of the same weight: along a Morton curve or, of very many, as they come, which for most
/// scans is much the same.
class OrderOfPoints {
public:
    OrderOfPoints() = default;
    /// pointAt(i) gives the points, which lie in the bounds; it is not kept. Without weights, one
    /// for each, all weigh the same.
    OrderOfPoints(std::uint64_t count, const Box &bounds,
                  const std::function<Point(std::size_t)> &pointAt,
                  const std::vector<double> &weights = {})
        : count_(count)
    {
        if (count <= mostOrdered)
            order_ = MortonOrder(bounds).indices(static_cast<std::size_t>(count), pointAt);
        double sum = 0;
        for (std::size_t place = 0; place < weights.size(); ++place)
            sums_.push_back(sum += weights[static_cast<std::size_t>(at(place))]);
    }

    /// Index of a point of a stratum, of so many: each point is as likely as it weighs, and where
    /// all weigh the same and there are as many strata as points, each is drawn once.
    std::uint64_t draw(Random &random, std::size_t stratum, std::size_t strata) const
    {
        const double weight = sums_.empty() ? static_cast<double>(count_) : sums_.back();
        const double length = weight / static_cast<double>(strata);
        const double along = (static_cast<double>(stratum) + random.unit()) * length;
        return at(std::min(placeOf(along), count_ - 1));
    }

private:
    std::uint64_t at(std::uint64_t place) const
    {
        return order_.empty() ? place : order_[static_cast<std::size_t>(place)];
    }

    std::uint64_t placeOf(double along) const
    {
        if (sums_.empty())
            return static_cast<std::uint64_t>(along);
        return static_cast<std::uint64_t>(std::upper_bound(sums_.begin(), sums_.end(), along) -
                                          sums_.begin());
    }

    /// 16 MB of indices.
    static constexpr std::uint64_t mostOrdered = std::uint64_t(1) << 22;

    std::uint64_t count_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<double> sums_; ///< of the weights up to each place
};

} // namespace neuralmesh
