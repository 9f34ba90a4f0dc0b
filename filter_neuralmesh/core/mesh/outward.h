// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Turns each closed component so that its faces look out of the body: away from what it encloses,
/// or, where it lies inside an odd number of others, as the wall of a cavity does, into it. Open
/// components have no outside and stay as they are. Works on rings: faces are to be rebuilt.
void orientOutwards(NeuralMesh &mesh);

/// The same, and makes the faces, of rings that will not change.
void makeOutwardFaces(NeuralMesh &mesh);

} // namespace neuralmesh
