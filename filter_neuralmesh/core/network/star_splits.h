// SPDX-License-Identifier: GPL-3.0-or-later
// How the star of a vertex is divided when it is split (section 3.2 of the paper, and other ways).
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A split of `vertex` whose new vertex takes the ring from place `first` counter-clockwise to
/// `last`, either of which may be gapPlace on a boundary.
struct StarSplit {
    VertexId vertex = noVertex;
    int first = 0;
    int last = 0;
};

/// Ring place of v's longest edge, of those that are not overlong where there are any: an edge
/// across a void is not where growth should go.
int longestEdge(const NeuralMesh &mesh, VertexId v);

/// The paper's: the edges that halve the star, on both sides of the edge at ring place `edge`.
/// Where that is an edge of a boundary, the new vertex lies on the boundary, too.
StarSplit halvingSplit(const NeuralMesh &mesh, VertexId v, int edge);

/// Of all splits with that edge on the new vertex's side, the one with the least sum of squared
/// excess valences over the vertices touched; of equals, the most even about the edge.
StarSplit balancedSplit(const NeuralMesh &mesh, VertexId v, int edge);

/// The split of a neighbour of v that gives v one neighbour more and lowers the sum of
/// squared excess valences most. Its vertex is noVertex where none lowers it.
StarSplit bestRaisingSplit(const NeuralMesh &mesh, VertexId v);

/// Half-way from the vertex to the middle of the neighbours that its new vertex takes.
Point3 middleOfSpan(const NeuralMesh &mesh, const StarSplit &star);

} // namespace neuralmesh
