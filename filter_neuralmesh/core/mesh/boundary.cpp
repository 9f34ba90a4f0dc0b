// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary.h"

#include "core/mesh/edge_lengths.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/vertex_data.h"

namespace neuralmesh {

VertexId startOfLongestBoundaryEdge(const NeuralMesh &mesh, const std::vector<VertexId> &vertices)
{
    VertexId longest = noVertex;
    Scalar length = -1;
    for (const VertexId v : vertices) {
        if (!mesh.isOnBoundary(v))
            continue;
        const Scalar other = edgeLength(mesh, v, nextOnBoundary(mesh, v));
        if (other > length) {
            length = other;
            longest = v;
        }
    }
    return longest;
}

bool isClosed(const NeuralMesh &mesh)
{
    bool isClosed = true;
    forEachVertex(mesh, [&](VertexId v) { isClosed = isClosed && !mesh.isOnBoundary(v); });
    return isClosed;
}

std::vector<std::vector<VertexId>> boundaryLoops(const NeuralMesh &mesh)
{
    std::vector<std::vector<VertexId>> loops;
    VertexData<char> isSeen(mesh, 0);
    forEachVertex(mesh, [&](VertexId start) {
        if (!mesh.isOnBoundary(start) || isSeen[start] != 0)
            return;
        std::vector<VertexId> &loop = loops.emplace_back();
        for (VertexId v = start; isSeen[v] == 0; v = nextOnBoundary(mesh, v)) {
            isSeen[v] = 1;
            loop.push_back(v);
        }
    });
    return loops;
}

} // namespace neuralmesh
