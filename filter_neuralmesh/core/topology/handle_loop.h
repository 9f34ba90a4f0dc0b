// SPDX-License-Identifier: GPL-3.0-or-later
// Loops around the handles of a mesh: closed curves that do not cut it in two.
//
// Eppstein: Dynamic generators of topologically embedded graphs (SODA 2003), the tree-cotree
// decomposition; Erickson, Whittlesey: Greedy optimal homotopy and homology generators (SODA 2005),
// shortest loops by it.
#pragma once

#include <vector>

#include "core/mesh/face_table.h"
#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Loops of edges, 2 · genus of the root's component, none of which cuts the mesh in two: each
/// from the root's tree of shortest paths along two of its branches, less what both have in common,
/// shortest first. The first is no longer than the shortest such loop through the root.
std::vector<std::vector<VertexId>> handleLoops(const NeuralMesh &mesh, const FaceTable &faces,
                                               VertexId root);

} // namespace neuralmesh
