// SPDX-License-Identifier: GPL-3.0-or-later
// The boundaries of the network: closed loops of edges with the surface on one side.
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// The next and the previous vertex along the boundary, the surface to the left. v must lie on one.
inline VertexId nextOnBoundary(const NeuralMesh &mesh, VertexId v)
{
    return mesh.ring(v)[0];
}
inline VertexId previousOnBoundary(const NeuralMesh &mesh, VertexId v)
{
    return mesh.ring(v)[mesh.valence(v) - 1];
}

/// Whether the edge between two neighbours is one of a boundary.
inline bool isBoundaryEdge(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const NeighbourRing &ring = mesh.ring(v);
    return ring.isOpen() && ring.isBoundaryEdge(ring.find(u));
}

/// Whether a place is further than `reach` from a vertex on a boundary.
inline bool isBeyondBorder(const NeuralMesh &mesh, VertexId v, const Point3 &place, Scalar reach)
{
    return mesh.isOnBoundary(v) && (mesh.position(v) - place).Norm() > reach;
}

/// Where the longest edge of a boundary starts, of those from the vertices; noVertex without any.
VertexId startOfLongestBoundaryEdge(const NeuralMesh &mesh, const std::vector<VertexId> &vertices);

/// Whether no vertex lies on a boundary.
bool isClosed(const NeuralMesh &mesh);

/// Every boundary, the surface to its left, its lowest id first.
std::vector<std::vector<VertexId>> boundaryLoops(const NeuralMesh &mesh);

} // namespace neuralmesh
