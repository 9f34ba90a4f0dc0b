// SPDX-License-Identifier: GPL-3.0-or-later
// Tells a plate, a wall with points on both of its sides, from a sheet with noise.
#pragma once

#include "core/space/point_index.h"

namespace neuralmesh {

/// Whether the points lie on two sides of a wall that is thinner than the radius, and at least that
/// thick. Around most of them, then, the heights above the best quadric (of x, y, x², xy, y²) have
/// two peaks. Noise has one, and so has the rounding of coordinates, which is uniform.
bool haveTwoSides(const PointIndex &index, double radius, double leastThickness);

} // namespace neuralmesh
