// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "neuralmesh/random.h"

namespace neuralmesh {

/// So many points in a row, in strata of equal length: each point is as likely as any other, and
/// where there are as many strata as points, each is drawn once.
class StrataOfPoints {
public:
    StrataOfPoints(std::uint64_t points, std::size_t strata)
        : last_(points - 1), length_(static_cast<double>(points) / static_cast<double>(strata))
    {
    }

    /// Index of a point of the stratum.
    std::uint64_t draw(Random &random, std::size_t stratum) const
    {
        const double place = (static_cast<double>(stratum) + random.unit()) * length_;
        return std::min(static_cast<std::uint64_t>(place), last_);
    }

private:
    std::uint64_t last_;
    double length_; ///< of a stratum, in points
};

} // namespace neuralmesh
