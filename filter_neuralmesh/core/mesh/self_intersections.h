// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

struct SelfIntersections {
    int faces = 0;                 ///< that intersect another
    std::vector<VertexId> corners; ///< of these, ascending
};

/// Makes the mesh's faces anew and asks VCG, which tests the faces that share a cell of a grid with
/// each other.
SelfIntersections findSelfIntersections(NeuralMesh &mesh);

} // namespace neuralmesh
