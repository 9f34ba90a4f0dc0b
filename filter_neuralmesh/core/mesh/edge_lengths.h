// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths of edges, and the lengths around a vertex by which other lengths are judged.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

inline Scalar edgeLength(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    return (mesh.position(v) - mesh.position(u)).Norm();
}

/// Mean length of the edges of v.
Scalar meanEdge(const NeuralMesh &mesh, VertexId v);

/// Mean of that over the vertices of a mesh.
Scalar meanEdge(const NeuralMesh &mesh);

/// Length of the shortest edge of v.
Scalar shortestEdge(const NeuralMesh &mesh, VertexId v);

/// Spacing of the vertices around v: the mean length of its three shortest edges (of two, where it
/// has no more), which stays true where up to half of the star is a web.
Scalar localSpacing(const NeuralMesh &mesh, VertexId v);

} // namespace neuralmesh
