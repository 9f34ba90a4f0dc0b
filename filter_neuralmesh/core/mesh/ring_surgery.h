// SPDX-License-Identifier: GPL-3.0-or-later
// Operations that change the topology of the network: a bridge between two discs, a cut along a
// loop. Each leaves the mesh a closed oriented two-manifold and moves no vertex.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Two discs without a vertex in common, by their rims (loops with the disc to the left), are taken
/// out and the rims joined by a band of faces. `rungs` are the band's edges in order (places in
/// either rim; see AnnulusTriangulation); none may be an edge of the mesh already. Nothing is
/// joined to vertices inside the discs any more; they are left for the caller to remove.
void bridgeDiscs(NeuralMesh &mesh, const std::vector<VertexId> &firstRim,
                 const std::vector<VertexId> &secondRim,
                 const std::vector<std::pair<int, int>> &rungs);

/// Whether a cut along the loop leaves more than the loop on either side of every vertex of it.
bool canCut(const NeuralMesh &mesh, const std::vector<VertexId> &loop);

/// Cuts the mesh open along a loop of edges. What lies to its left keeps the loop's vertices, what
/// lies to its right gets copies, which are returned in the loop's order. Requires canCut(). The
/// two holes are to be filled, by refillDisc(): to the left of the loop backwards, and to the left
/// of the copies forwards.
std::vector<VertexId> cutOpen(NeuralMesh &mesh, const std::vector<VertexId> &loop);

} // namespace neuralmesh
