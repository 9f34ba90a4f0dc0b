// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// How many points the largest group has: points belong together that are no further from each
/// other than `distance`, and all that do so by way of others. 0 of none.
std::size_t largestGroup(const std::vector<Point3> &points, double distance);

} // namespace neuralmesh
