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
    /// pointAt(i) gives the points, which lie in the bounds; it is not kept. All weigh the same.
    OrderOfPoints(std::uint64_t count, const Box &bounds,
                  const std::function<Point(std::size_t)> &pointAt)
        : count_(count)
    {
        if (count <= mostOrdered)
            order_ = MortonOrder(bounds).indices(static_cast<std::size_t>(count), pointAt);
    }

    std::uint64_t count() const { return count_; }

    /// Index of the point at a place of the order.
    std::uint64_t at(std::uint64_t place) const
    {
        return order_.empty() ? place : order_[static_cast<std::size_t>(place)];
    }

    /// Entry i of n is the weight of each point from place i * count / n up to the next entry's.
    /// There are at most as many as points; without any, all weigh the same.
    void weigh(const std::vector<double> &weights)
    {
        sums_.clear();
        double sum = 0;
        for (std::size_t run = 0; run < weights.size(); ++run) {
            const std::uint64_t points =
                startOf(run + 1, weights.size()) - startOf(run, weights.size());
            sums_.push_back(sum += weights[run] * static_cast<double>(points));
        }
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
    std::uint64_t placeOf(double along) const
    {
        if (sums_.empty())
            return static_cast<std::uint64_t>(along);
        const auto above = std::upper_bound(sums_.begin(), sums_.end() - 1, along);
        const auto run = static_cast<std::size_t>(above - sums_.begin());
        const double before = run > 0 ? sums_[run - 1] : 0;
        const std::uint64_t start = startOf(run, sums_.size());
        const std::uint64_t points = startOf(run + 1, sums_.size()) - start;
        const double within = (along - before) / (*above - before) * static_cast<double>(points);
        return start + std::min(static_cast<std::uint64_t>(within), points - 1);
    }

    /// Place of the first point of a run, of so many.
    std::uint64_t startOf(std::size_t run, std::size_t runs) const { return run * count_ / runs; }

    /// 16 MB of indices.
    static constexpr std::uint64_t mostOrdered = std::uint64_t(1) << 22;

    std::uint64_t count_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<double> sums_; ///< of the weights up to the end of each run
};

} // namespace neuralmesh
