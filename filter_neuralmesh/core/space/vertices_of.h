// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/enumeration.h"
#include "core/space/point_grid.h"

namespace neuralmesh {

/// An index of the mesh's vertices, which serves as long as none of them moves.
inline PointGrid verticesOf(const NeuralMesh &mesh, const Box3 &bounds)
{
    std::vector<PointGrid::Entry> entries;
    entries.reserve(static_cast<std::size_t>(mesh.vn));
    forEachVertex(mesh, [&](VertexId v) { entries.push_back({mesh.position(v), v}); });
    return {bounds, std::move(entries)};
}

} // namespace neuralmesh
