// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on discs and loops of the network: a disc is filled anew or taken out, a hole filled,
// two discs or holes are bridged, the surface is cut along a loop. Each leaves the mesh an oriented
// two-manifold and moves no vertex.
//
// The rim of a disc is the loop around it, its faces to the left. So is that of a hole: the
// boundary walked backwards, the surface to its right.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/loop_triangulation.h"
#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Replaces a disc, or fills a hole, by the triangulation of its rim and removes its interior
/// vertices. No diagonal may be an edge outside the disc.
void refillDisc(NeuralMesh &mesh, const std::vector<VertexId> &rim,
                const std::vector<VertexId> &interior, const std::vector<LoopTriangle> &triangles);

/// Whether the disc may be taken out: its rim touches no boundary, and each of its vertices keeps a
/// face.
bool canOpenDisc(const NeuralMesh &mesh, const std::vector<VertexId> &rim);

/// Takes out the faces of a disc and its interior vertices, and leaves a hole with the same rim.
/// Requires canOpenDisc().
void openDisc(NeuralMesh &mesh, const std::vector<VertexId> &rim,
              const std::vector<VertexId> &interior);

/// Two discs or holes without a vertex in common, by their rims, are taken out and the rims joined
/// by a band of faces. `rungs` are the band's edges in order (places in either rim; see
/// AnnulusTriangulation); none may be an edge of the mesh already. Nothing is joined to vertices
/// inside the discs any more; they are left for the caller to remove.
void bridgeDiscs(NeuralMesh &mesh, const std::vector<VertexId> &firstRim,
                 const std::vector<VertexId> &secondRim,
                 const std::vector<std::pair<int, int>> &rungs);

/// Whether a cut along the loop leaves more than the loop on either side of every vertex of it.
/// None of them may be on a boundary.
bool canCut(const NeuralMesh &mesh, const std::vector<VertexId> &loop);

/// Cuts the mesh open along a loop of edges. What lies to its left keeps the loop's vertices, what
/// lies to its right gets copies, which are returned in the loop's order. Requires canCut(). The
/// rims of the two holes are the loop backwards and the copies forwards.
std::vector<VertexId> cutOpen(NeuralMesh &mesh, const std::vector<VertexId> &loop);

} // namespace neuralmesh
