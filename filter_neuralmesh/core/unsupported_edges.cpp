// SPDX-License-Identifier: GPL-3.0-or-later
#include "unsupported_edges.h"

#include <algorithm>
#include <limits>

#include "ring_topology.h"

namespace neuralmesh {
namespace {

/// Times the local spacing from which an edge counts as unsupported.
constexpr Scalar unsupportedRatio = 2.5;

/// A flip must shorten by this factor to count as progress.
constexpr Scalar shortening = 0.8;

Scalar distance(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    return (mesh.position(v) - mesh.position(u)).Norm();
}

Scalar flippedLength(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    return distance(mesh, opposite.left, opposite.right);
}

bool flipIfMuchShorter(NeuralMesh &mesh, VertexId v, VertexId u)
{
    if (!canFlip(mesh, v, u) || flippedLength(mesh, v, u) > shortening * distance(mesh, v, u))
        return false;
    flip(mesh, v, u);
    return true;
}

/// Where the opposite vertices lie on different sides of the void, flipping a long edge of the rim
/// first puts another vertex opposite. Tries each of the four rim edges.
bool flipAfterNeighbour(NeuralMesh &mesh, VertexId v, VertexId u)
{
    const Scalar length = distance(mesh, v, u);
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    const VertexId rim[4][2] = {
        {v, opposite.left}, {u, opposite.left}, {v, opposite.right}, {u, opposite.right}};
    for (const auto &[end, corner] : rim) {
        if (!isUnsupported(mesh, end, corner) || !canFlip(mesh, end, corner))
            continue;
        const Scalar before = length + distance(mesh, end, corner);
        const Scalar rimAfter = flippedLength(mesh, end, corner);
        const OppositeVertices undo = oppositeVertices(mesh, end, corner);
        flip(mesh, end, corner);
        if (mesh.ring(v).contains(u) && canFlip(mesh, v, u) &&
            flippedLength(mesh, v, u) <= shortening * length &&
            flippedLength(mesh, v, u) + rimAfter <= shortening * before) {
            flip(mesh, v, u);
            return true;
        }
        flip(mesh, undo.left, undo.right);
    }
    return false;
}

} // namespace

Scalar localSpacing(const NeuralMesh &mesh, VertexId v)
{
    constexpr Scalar unknown = std::numeric_limits<Scalar>::infinity();
    Scalar shortest[3] = {unknown, unknown, unknown};
    for (const VertexId u : mesh.ring(v)) {
        Scalar length = (mesh.position(u) - mesh.position(v)).SquaredNorm();
        for (Scalar &held : shortest)
            if (length < held)
                std::swap(length, held);
    }
    return (std::sqrt(shortest[0]) + std::sqrt(shortest[1]) + std::sqrt(shortest[2])) / 3;
}

bool isUnsupported(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const Scalar spacing = (localSpacing(mesh, v) + localSpacing(mesh, u)) / 2;
    return distance(mesh, v, u) > unsupportedRatio * spacing;
}

int retractWebs(NeuralMesh &mesh)
{
    int flips = 0;
    std::vector<VertexId> open;
    for (VertexId v = mesh.idBound(); v-- > 0;)
        if (mesh.isLive(v))
            open.push_back(v);
    // A flip frees edges around it: its four corners are looked at again.
    while (!open.empty()) {
        const VertexId v = open.back();
        open.pop_back();
        for (int i = 0; i < mesh.valence(v); ++i) {
            const VertexId u = mesh.ring(v)[i];
            if (!isUnsupported(mesh, v, u))
                continue;
            const OppositeVertices opposite = oppositeVertices(mesh, v, u);
            if (!flipIfMuchShorter(mesh, v, u) && !flipAfterNeighbour(mesh, v, u))
                continue;
            ++flips;
            open.insert(open.end(), {opposite.right, opposite.left, u, v});
            break;
        }
    }
    return flips;
}

} // namespace neuralmesh
