// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart the points of a target space are, beside the vertices that are to lie among them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace neuralmesh {

/// Points for each vertex that tell as much as any number of samples: their spacing is well below
/// the mesh's edges.
inline constexpr double pointsPerVertex = 5;

/// The factor by which a sample counts as near from further away, where points are fewer than that:
/// their spacing grows as the root of their number falls. 1 at the least.
inline double wideningForFewPoints(std::size_t points, int vertices)
{
    return std::sqrt(std::max(1.0, pointsPerVertex / (static_cast<double>(points) / vertices)));
}

} // namespace neuralmesh
