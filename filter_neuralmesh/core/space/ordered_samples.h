// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/parallel/watch.h"
#include "core/space/morton_order.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Samples of a target space, sorted by space: those that were drawn last. They are drawn in parts,
/// between which the watch is looked at.
class OrderedSamples {
public:
    /// Both must outlive it.
    OrderedSamples(const Sampler &sampler, Watch &watch);

    /// So many independent ones, which replace those before.
    const std::vector<Point3> &draw(Random &random, std::size_t count);
    /// One of each of so many strata.
    const std::vector<Point3> &drawStratified(Random &random, std::size_t strata);

    const std::vector<Point3> &last() const { return ordered_; }

private:
    template <class Draw> void drawParts(std::size_t count, const Draw &draw);

    const Sampler &sampler_;
    Watch &watch_;
    MortonOrder order_;
    std::vector<Point> drawn_;
    std::vector<Point> part_;
    std::vector<Point3> ordered_;
};

} // namespace neuralmesh
