// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart points are, and whether much further in one place than in another.
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/space/point_tree.h"

namespace neuralmesh {

/// The spacing of a point is the distance to this neighbour of it.
constexpr int neighbourOfSpacing = 8;

/// Spacings at the dense end and at the sparse one: a tenth of the points have less, and those of a
/// tenth of the surface more. Half of a surface may have next to none of its points.
struct SpacingSpread {
    double dense = 0;
    double sparse = 0;

    bool isUneven() const;
};

/// Of distinct points, as far as `tree` is of them; at least one. Strays are no sparse end: where
/// there is one, a point has the usual spacing of its neighbours.
SpacingSpread spacingSpread(const std::vector<Point3> &distinct, PointTree &tree);

} // namespace neuralmesh
