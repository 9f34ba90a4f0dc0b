// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity of the network: vertex split, edge collapse, edge flip on neighbour rings.
//
// Each operation has a pure test (can...) and a change that cannot fail once the test has passed.
// They keep the mesh a closed oriented two-manifold and move no vertex.
#pragma once

#include <vector>

#include "core/mesh/loop_triangulation.h"
#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// The vertices opposite to edge (v, u): face (v, u, left) and face (u, v, right).
struct OppositeVertices {
    VertexId left;
    VertexId right;
};

/// u must be a neighbour of v.
OppositeVertices oppositeVertices(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Whether edge (v, u) may collapse: the link condition (v and u have just their two opposite
/// vertices in common), and their component is no tetrahedron, which stays one. False where v and
/// u are no neighbours.
bool canCollapse(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Removes v by collapsing edge (v, u) into u, whose position stays. Requires canCollapse(v, u).
void collapse(NeuralMesh &mesh, VertexId v, VertexId u);

/// Splits v: the new vertex w, already in the mesh without neighbours, takes the neighbours of v
/// from ring place `first` to `last` counter-clockwise; both of these become neighbours of both.
/// Requires first != last. With a span of s steps between them, w gets valence s + 2 and v keeps
/// valence(v) - s + 2, so v keeps at least 3 where s < valence(v).
void split(NeuralMesh &mesh, VertexId v, int first, int last, VertexId w);

/// Whether edge (v, u) may flip: its opposite vertices are not neighbours already, and v and u
/// keep valence 3. False where v and u are no neighbours.
bool canFlip(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Replaces edge (v, u) by the edge between its opposite vertices. Requires canFlip(v, u).
void flip(NeuralMesh &mesh, VertexId v, VertexId u);

/// Replaces a disc by the triangulation of its rim (the loop around it, its faces to the left) and
/// removes its interior vertices. No diagonal may be an edge outside the disc.
void refillDisc(NeuralMesh &mesh, const std::vector<VertexId> &rim,
                const std::vector<VertexId> &interior, const std::vector<LoopTriangle> &triangles);

/// Makes mesh.face from the rings, each face once, its lowest id first. Removed vertices' slots
/// stay: compact on the way out.
void rebuildFaces(NeuralMesh &mesh);

/// Turns every ring round: the inside becomes the outside.
void reverseOrientation(NeuralMesh &mesh);

} // namespace neuralmesh
