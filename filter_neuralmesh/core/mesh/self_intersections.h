// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/parallel/workers.h"

namespace neuralmesh {

struct SelfIntersections {
    int faces = 0;                 ///< that intersect another
    std::vector<VertexId> corners; ///< of these, ascending
};

/// Makes the mesh's faces anew, and tests those whose boxes meet with each other: whether an edge
/// of one passes through the other, whatever their size, or both lie upon each other in one plane.
/// The mesh stays as it is where the watch of the workers throws.
SelfIntersections findSelfIntersections(NeuralMesh &mesh, Workers &workers);
SelfIntersections findSelfIntersections(NeuralMesh &mesh);

} // namespace neuralmesh
