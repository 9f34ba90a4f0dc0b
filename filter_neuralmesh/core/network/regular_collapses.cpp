// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/regular_collapses.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/mesh/enumeration.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/triangle.h"
#include "core/network/star_projection.h"
#include "core/network/valences.h"

namespace neuralmesh {
namespace {

/// Cosines of the largest turn of a face, 35 degrees, and of an angle that is good enough, 20.
constexpr Scalar mostTurnCosine = 0.819;
constexpr Scalar goodAngleCosine = 0.940;

/// How far the vertex that goes may stand out from the faces that are left, in lengths of the edge
/// that collapses: a limb's tip stays.
constexpr Scalar mostHeight = 0.2;

/// Whether the faces of v, with v moved to its neighbour u, are as good as before.
bool collapseKeepsSurface(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    bool turns = false;
    Scalar sliverBefore = 0;
    Scalar sliverAfter = 0;
    Scalar height = std::numeric_limits<Scalar>::infinity(); // squared
    forEachFaceAround(mesh, v, [&](VertexId a, VertexId b) {
        const Triangle before{mesh.position(v), mesh.position(a), mesh.position(b)};
        sliverBefore = std::max(sliverBefore, cosineOfSmallestAngle(before));
        if (a == u || b == u)
            return;
        const Triangle after{mesh.position(u), mesh.position(a), mesh.position(b)};
        sliverAfter = std::max(sliverAfter, cosineOfSmallestAngle(after));
        turns = turns || !(unitNormal(before) * unitNormal(after) > mostTurnCosine);
        height = std::min(height, squaredDistanceTo(after, mesh.position(v)));
    });
    if (turns)
        return false;
    if (height > mostHeight * mostHeight * (mesh.position(u) - mesh.position(v)).SquaredNorm())
        return false;
    return sliverAfter <= std::max(sliverBefore, goodAngleCosine);
}

/// Sum of squared excess valences after the collapse of v into u: of u, which gets all neighbours
/// but two, itself and v, and of the opposite vertices, which lose v.
int spreadAfterCollapse(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    int valence = mesh.valence(v) + mesh.valence(u) - 2;
    int spread = 0;
    for (const VertexId x : {opposite.left, opposite.right})
        if (x != noVertex) {
            --valence; // a neighbour of both
            spread += squared(valenceExcess(mesh, x) - 1);
        }
    return spread + squared(valence - idealValence(mesh.isOnBoundary(v) || mesh.isOnBoundary(u)));
}

template <class MayCollapse>
VertexId leastRegularityError(const NeuralMesh &mesh, VertexId v, MayCollapse mayCollapse)
{
    VertexId best = noVertex;
    int least = std::numeric_limits<int>::max();
    for (const VertexId u : mesh.ring(v)) {
        // Equation 9 without its root and factor, which keep the order.
        const int error = spreadAfterCollapse(mesh, v, u);
        if (error < least && canCollapse(mesh, v, u) && mayCollapse(u)) {
            least = error;
            best = u;
        }
    }
    return best;
}

/// By how much the collapse of v into u lowers the sum of squared excess valences.
int gainOfCollapse(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    int before = squared(valenceExcess(mesh, v)) + squared(valenceExcess(mesh, u));
    for (const VertexId x : {opposite.left, opposite.right})
        before += x == noVertex ? 0 : squared(valenceExcess(mesh, x));
    return before - spreadAfterCollapse(mesh, v, u);
}

} // namespace

std::vector<VertexId> mostRegularCollapses(const NeuralMesh &mesh)
{
    std::vector<std::pair<int, VertexId>> found; // the gain, negative: the most comes first
    forEachVertex(mesh, [&](VertexId v) {
        if (mesh.isOnBoundary(v) || valenceExcess(mesh, v) != -1)
            return;
        const VertexId into = bestCollapse(mesh, v);
        if (into == noVertex)
            return;
        if (const int gain = gainOfCollapse(mesh, v, into); gain > 0)
            found.emplace_back(-gain, v);
    });
    std::sort(found.begin(), found.end());
    std::vector<VertexId> vertices;
    for (const auto &[gain, v] : found)
        vertices.push_back(v);
    return vertices;
}

VertexId bestCollapse(const NeuralMesh &mesh, VertexId v)
{
    return leastRegularityError(mesh, v, [](VertexId) { return true; });
}

VertexId bestCollapseOnSurface(const NeuralMesh &mesh, VertexId v)
{
    return leastRegularityError(mesh, v,
                                [&](VertexId u) { return collapseKeepsSurface(mesh, v, u); });
}

VertexCollapse leastVisibleCollapse(const NeuralMesh &mesh)
{
    std::vector<VertexId> candidates = mostRegularCollapses(mesh);
    forEachVertex(mesh, [&](VertexId v) { candidates.push_back(v); });
    for (const auto best : {bestCollapseOnSurface, bestCollapse})
        for (const VertexId v : candidates)
            if (const VertexId into = best(mesh, v); into != noVertex)
                return {v, into};
    return {};
}

} // namespace neuralmesh
