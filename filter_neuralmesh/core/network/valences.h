// SPDX-License-Identifier: GPL-3.0-or-later
// What the valences are to be, and how far one is from that.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Of a vertex inside the surface, and of one on a boundary: equilateral triangles all round, and
/// half round.
constexpr int idealValence(bool isOnBoundary)
{
    return isOnBoundary ? 4 : 6;
}

constexpr int squared(int x)
{
    return x * x;
}

/// By how much v's valence is above that of its kind.
inline int valenceExcess(const NeuralMesh &mesh, VertexId v)
{
    return mesh.valence(v) - idealValence(mesh.isOnBoundary(v));
}

} // namespace neuralmesh
