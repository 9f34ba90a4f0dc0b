// SPDX-License-Identifier: GPL-3.0-or-later
// Notches and slits in the boundary, narrower than the edges beside them: no shape of the target
// space, but of the way in which the boundary came there.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Whether the boundary turns back at v, the surface outside the turn, so far that an equilateral
/// triangle would not fit in, or does so at the edge that follows v, much shorter than those
/// beside.
bool isNotch(const NeuralMesh &mesh, VertexId v);

/// Fills notches by a face each, which closes a slit like a zip, until there is none. Returns how
/// many were filled.
int fillNotches(NeuralMesh &mesh);

} // namespace neuralmesh
