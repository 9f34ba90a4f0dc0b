// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// The corners of all faces that intersect another, ascending. Makes the mesh's faces anew and asks
/// VCG, which tests the faces that share a cell of a grid with each other.
std::vector<VertexId> findIntersectingVertices(NeuralMesh &mesh);

} // namespace neuralmesh
