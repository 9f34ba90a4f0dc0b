// SPDX-License-Identifier: GPL-3.0-or-later
// Tells a plate, a wall with points on both of its sides, from a sheet with noise.
#pragma once

#include "core/space/point_index.h"

namespace neuralmesh {

/// Whether the points lie on two sides of a wall that is thinner than the radius. Around most of
/// them, then, the heights above the best quadric (of x, y, x², xy, y²) have two peaks. Their
/// kurtosis is near 1, of a uniform distribution 1.8, of noise 3 (Darlington: Is kurtosis really
/// "peakedness"?, The American Statistician 1970).
bool haveTwoSides(const PointIndex &index, double radius);

} // namespace neuralmesh
