// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/small_parts.h"

#include <algorithm>
#include <vector>

#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/triangle.h"

namespace neuralmesh {

void removeSmallParts(NeuralMesh &mesh, double leastArea)
{
    const std::vector<int> label = labelComponents(mesh);
    const auto of = [&](VertexId v) { return static_cast<std::size_t>(label[v]); };
    std::vector<double> areas(label.size(), 0);
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        areas[of(a)] += area(Triangle{mesh.position(a), mesh.position(b), mesh.position(c)});
    });
    const double least = std::min(leastArea, *std::max_element(areas.begin(), areas.end()));
    forEachVertex(mesh, [&](VertexId v) {
        if (areas[of(v)] < least)
            mesh.removeVertex(v);
    });
}

} // namespace neuralmesh
