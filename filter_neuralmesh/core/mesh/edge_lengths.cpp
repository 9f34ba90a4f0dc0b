// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/edge_lengths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mesh/enumeration.h"

namespace neuralmesh {
namespace {

constexpr Scalar unknown = std::numeric_limits<Scalar>::infinity();

} // namespace

Scalar meanEdge(const NeuralMesh &mesh, VertexId v)
{
    const auto valence = static_cast<Scalar>(mesh.valence(v));
    Scalar mean = 0;
    for (const VertexId u : mesh.ring(v))
        mean += edgeLength(mesh, u, v) / valence;
    return mean;
}

Scalar meanEdge(const NeuralMesh &mesh)
{
    Scalar sum = 0;
    forEachVertex(mesh, [&](VertexId v) { sum += meanEdge(mesh, v); });
    return sum / static_cast<Scalar>(mesh.vn);
}

Scalar shortestEdge(const NeuralMesh &mesh, VertexId v)
{
    Scalar shortest = unknown;
    for (const VertexId u : mesh.ring(v))
        shortest = std::min(shortest, edgeLength(mesh, u, v));
    return shortest;
}

Scalar localSpacing(const NeuralMesh &mesh, VertexId v)
{
    Scalar shortest[3] = {unknown, unknown, unknown};
    for (const VertexId u : mesh.ring(v)) {
        Scalar length = (mesh.position(u) - mesh.position(v)).SquaredNorm();
        for (Scalar &held : shortest)
            if (length < held)
                std::swap(length, held);
    }
    const Scalar two = std::sqrt(shortest[0]) + std::sqrt(shortest[1]);
    return mesh.valence(v) < 3 ? two / 2 : (two + std::sqrt(shortest[2])) / 3;
}

} // namespace neuralmesh
