// SPDX-License-Identifier: GPL-3.0-or-later
// Whether points are much further apart in one place than in another.
#pragma once

#include <vector>

#include "core/space/point_statistics.h"

namespace neuralmesh {

/// Neighbours of a point whose distance is taken for its spacing.
constexpr int neighboursOfSpacing = 8;

/// Spacings at the dense end and at the sparse one: a tenth of the points have less, and a tenth
/// more.
struct SpacingSpread {
    double dense = 0;
    double sparse = 0;

    /// That of a uniform random sample has a ratio of 1.6.
    bool isUneven() const { return sparse > leastRatio * dense; }

    static constexpr double tenth = 0.1;
    static constexpr double leastRatio = 2;
};

/// Requires at least one spacing.
inline SpacingSpread spreadOf(const std::vector<double> &spacings)
{
    return {quantile(spacings, SpacingSpread::tenth), quantile(spacings, 1 - SpacingSpread::tenth)};
}

} // namespace neuralmesh
