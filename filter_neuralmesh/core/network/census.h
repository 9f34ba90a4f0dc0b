// SPDX-License-Identifier: GPL-3.0-or-later
// Finds misplaced vertices: those that win none of many samples.
#pragma once

#include <cstddef>
#include <vector>

#include "core/network/growing_network.h"

namespace neuralmesh {

class Census {
public:
    /// Of a network of so many vertices, on a target space of so many points.
    Census(int vertices, std::size_t points);

    /// How many samples it needs.
    std::size_t samples() const { return samples_; }

    /// The vertices that are nearest to none of the samples; none where these are hardly more than
    /// by chance, so that others in their place would win nothing either.
    std::vector<VertexId> misplaced(const GrowingNetwork &network,
                                    const std::vector<Point3> &samples) const;

private:
    std::size_t samples_;
    double idleByChance_;
};

} // namespace neuralmesh
