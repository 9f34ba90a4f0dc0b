// SPDX-License-Identifier: GPL-3.0-or-later
// Finds misplaced vertices: those that win none of many samples, and those of faces that cross.
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

    /// The corners of faces that intersect another, whatever they win: where sheets have grown
    /// through each other, samples hold each on the wrong side; but not of an open surface. And the
    /// vertices that are nearest to none of the samples, but for those that are hardly more than by
    /// chance, as others in their place would win nothing either. In ascending order.
    std::vector<VertexId> misplaced(GrowingNetwork &network,
                                    const std::vector<Point3> &samples) const;

private:
    std::vector<VertexId> idle(const GrowingNetwork &network,
                               const std::vector<Point3> &samples) const;

    std::size_t samples_;
    double idleByChance_;
};

} // namespace neuralmesh
