// SPDX-License-Identifier: GPL-3.0-or-later
// All vertices, edges and faces of the network, each once. Faces are read off the rings.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Calls visit(v) for each vertex, ids ascending. Of vertices that come meanwhile, those in slots
/// used again are visited where their turn is still to come, those in new slots are not.
template <class Visit> void forEachVertex(const NeuralMesh &mesh, const Visit &visit)
{
    const VertexId bound = mesh.idBound();
    for (VertexId v = 0; v < bound; ++v)
        if (mesh.isLive(v))
            visit(v);
}

/// Calls visit(v, u) for each edge, v < u.
template <class Visit> void forEachEdge(const NeuralMesh &mesh, const Visit &visit)
{
    forEachVertex(mesh, [&](VertexId v) {
        for (const VertexId u : mesh.ring(v))
            if (v < u)
                visit(v, u);
    });
}

/// Calls visit(a, b) for each face (v, a, b) around v, counter-clockwise.
template <class Visit>
void forEachFaceAround(const NeuralMesh &mesh, VertexId v, const Visit &visit)
{
    const NeighbourRing &ring = mesh.ring(v);
    for (int i = 0; i < ring.faceCount(); ++i)
        visit(ring[i], ring[ring.next(i)]);
}

/// Calls visit(v, a, b) for each face, its lowest id first, counter-clockwise.
template <class Visit> void forEachFace(const NeuralMesh &mesh, const Visit &visit)
{
    forEachVertex(mesh, [&](VertexId v) {
        forEachFaceAround(mesh, v, [&](VertexId a, VertexId b) {
            if (v < a && v < b)
                visit(v, a, b);
        });
    });
}

} // namespace neuralmesh
