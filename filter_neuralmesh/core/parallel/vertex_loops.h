// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/neural_mesh.h"
#include "core/parallel/workers.h"

namespace neuralmesh {

/// Calls visit(v) for each vertex, on the workers' threads, in any order. What one call writes, no
/// other may read.
template <class Visit>
void forEachVertex(Workers &workers, const NeuralMesh &mesh, const Visit &visit)
{
    constexpr std::size_t verticesOfChunk = 512;
    workers.forEachChunk(mesh.idBound(), verticesOfChunk,
                         [&](std::size_t first, std::size_t end, int) {
                             for (auto v = static_cast<VertexId>(first); v < end; ++v)
                                 if (mesh.isLive(v))
                                     visit(v);
                         });
}

} // namespace neuralmesh
