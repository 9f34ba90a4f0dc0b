// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Takes out the components whose area is less than that, but for the largest: crumbs of a membrane
/// that was taken out.
void removeSmallParts(NeuralMesh &mesh, double leastArea);

} // namespace neuralmesh
