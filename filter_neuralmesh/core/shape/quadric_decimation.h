// SPDX-License-Identifier: GPL-3.0-or-later
// Fewer vertices for a mesh, by edge collapses in the order of their quadric error (Garland and
// Heckbert 1997).
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Collapses edges until `vertices` are left, or none may collapse any more: each keeps the
/// topology (link condition) and turns no face over. A collapsed edge's vertex lies at that of its
/// ends and its middle where the error is least. Vertices are numbered anew, in their order;
/// nothing may follow the mesh.
void decimate(NeuralMesh &mesh, int vertices);

} // namespace neuralmesh
