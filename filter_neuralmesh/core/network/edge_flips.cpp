// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/edge_flips.h"

#include <algorithm>

#include "core/mesh/boundary.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/triangle.h"
#include "core/network/valences.h"

namespace neuralmesh {
namespace {

/// Normals of the two faces at an edge that differ by more than this (40 degrees) make a crease.
constexpr Scalar creaseCosine = 0.766;
/// New faces may not turn away from each other by more than this (50 degrees).
constexpr Scalar foldCosine = 0.643;
/// Cosine of 30 degrees: angles above it are good enough to come from a flip.
constexpr Scalar goodAngleCosine = 0.866;
/// Of the cosine: keeps rounding from flipping an edge to and fro.
constexpr Scalar leastAngleGain = 1e-6;

/// The two faces at an edge.
struct FacePair {
    Triangle first, second;

    Scalar smallestAngleCosine() const
    {
        return std::max(cosineOfSmallestAngle(first), cosineOfSmallestAngle(second));
    }
};

FacePair facesNow(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    const Point3 &a = mesh.position(v);
    const Point3 &b = mesh.position(u);
    return {{a, b, mesh.position(opposite.left)}, {b, a, mesh.position(opposite.right)}};
}

FacePair facesWhenFlipped(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    const Point3 &left = mesh.position(opposite.left);
    const Point3 &right = mesh.position(opposite.right);
    return {{mesh.position(v), right, left}, {mesh.position(u), left, right}};
}

bool flipImproves(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const int gain = valenceGain(mesh, v, u);
    if (gain != 0)
        return gain > 0;
    return facesWhenFlipped(mesh, v, u).smallestAngleCosine() <
           facesNow(mesh, v, u).smallestAngleCosine() - leastAngleGain;
}

} // namespace

int valenceGain(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    // Both ends lose one and both opposite vertices win one; the squares cancel to this.
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    return 2 * (valenceExcess(mesh, v) + valenceExcess(mesh, u) -
                valenceExcess(mesh, opposite.left) - valenceExcess(mesh, opposite.right)) -
           4;
}

bool flipKeepsSurface(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const FacePair before = facesNow(mesh, v, u);
    const FacePair after = facesWhenFlipped(mesh, v, u);
    const Point3 normalsBefore[2] = {unitNormal(before.first), unitNormal(before.second)};
    const Point3 normalsAfter[2] = {unitNormal(after.first), unitNormal(after.second)};
    if (normalsBefore[0] * normalsBefore[1] < creaseCosine)
        return false;
    for (const Point3 &old : normalsBefore)
        for (const Point3 &made : normalsAfter)
            if (!(old * made > foldCosine))
                return false;
    return after.smallestAngleCosine() < std::max(before.smallestAngleCosine(), goodAngleCosine);
}

int evenValencesAround(NeuralMesh &mesh, VertexId v)
{
    int flips = 0;
    const auto flipIfBetter = [&](VertexId a, VertexId b) {
        if (isBoundaryEdge(mesh, a, b) || !flipImproves(mesh, a, b) || !canFlip(mesh, a, b) ||
            !flipKeepsSurface(mesh, a, b))
            return false;
        flip(mesh, a, b);
        ++flips;
        return true;
    };
    // Each flip lowers a sum of squares or, at the same sum, widens the smallest angle of its four
    // corners, so this ends. A flip changes the ring: start it anew.
    for (int i = 0; i < mesh.valence(v); ++i) {
        const NeighbourRing &ring = mesh.ring(v);
        const VertexId a = ring[i];
        if (flipIfBetter(v, a) || (ring.hasFaceAfter(i) && flipIfBetter(a, ring[ring.next(i)])))
            i = -1;
    }
    return flips;
}

} // namespace neuralmesh
