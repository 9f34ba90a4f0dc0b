// SPDX-License-Identifier: GPL-3.0-or-later
// Points of even density, out of points of any.
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Where points are several times as dense in one place as in another, takes out so many that they
/// are everywhere about as far apart as at the sparse end, and keeps the order of the others. What
/// is judged by the spacing of the points, such as a gap, needs one that holds everywhere.
/// Repeated points count once.
std::vector<Point3> withEvenDensity(const std::vector<Point3> &points);

} // namespace neuralmesh
