// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/enumeration.h"
#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Unit normal of a vertex, outwards: the sum of its faces' normals, weighted by area. Zero where
/// the star has no area.
inline Point3 starNormal(const NeuralMesh &mesh, VertexId v)
{
    const NeighbourRing &ring = mesh.ring(v);
    const Point3 &centre = mesh.position(v);
    Point3 normal(0, 0, 0);
    // Round a closed ring, the first face is that between the last neighbour and the first.
    Point3 previous = mesh.position(ring[ring.isOpen() ? 0 : ring.size() - 1]) - centre;
    for (int i = ring.isOpen() ? 1 : 0; i < ring.size(); ++i) {
        const Point3 edge = mesh.position(ring[i]) - centre;
        normal += previous ^ edge;
        previous = edge;
    }
    return normal.Normalize();
}

/// Whether a face around the vertex turns away from the star normal.
inline bool isFolded(const NeuralMesh &mesh, VertexId v)
{
    constexpr Scalar leastTurn = 0.2; // cosine of 78 degrees
    const Point3 &centre = mesh.position(v);
    const Point3 normal = starNormal(mesh, v);
    bool isFolded = false;
    forEachFaceAround(mesh, v, [&](VertexId a, VertexId b) {
        const Point3 face = (mesh.position(a) - centre) ^ (mesh.position(b) - centre);
        isFolded = isFolded || face * normal < leastTurn * face.Norm();
    });
    return isFolded;
}

} // namespace neuralmesh
