// SPDX-License-Identifier: GPL-3.0-or-later
// Edge flips that even out the valences where the surface allows.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// By how much flipping edge (v, u), none of a boundary, lowers the sum of squared excess valences
/// over the four vertices of its two faces.
int valenceGain(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Whether the flipped edge (v, u) would leave the surface as it is in all that can be seen: the
/// four corners are nearly flat there, so that no crease is lost, the two new faces do not fold,
/// and none of their angles is smaller than the smallest before or 30 degrees.
bool flipKeepsSurface(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Flips edges in the star of v and on its rim while that lowers the sum of squared excess
/// valences, or keeps the sum and widens the smallest angle, and keeps the surface. The second kind
/// lets pairs of valences 5 and 7 wander until they meet and vanish. Returns how many were flipped.
int evenValencesAround(NeuralMesh &mesh, VertexId v);

} // namespace neuralmesh
