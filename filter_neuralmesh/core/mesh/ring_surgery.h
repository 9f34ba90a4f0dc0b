// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on discs and loops of the network: a disc is filled anew or taken out, a hole filled.
// Each leaves the mesh an oriented two-manifold and moves no vertex.
//
// The rim of a disc is the loop around it, its faces to the left. So is that of a hole: the
// boundary walked backwards, the surface to its right.
#pragma once

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

} // namespace neuralmesh
