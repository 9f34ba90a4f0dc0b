// SPDX-License-Identifier: GPL-3.0-or-later
// Connectivity of the network: vertex split, edge collapse, edge flip on neighbour rings.
//
// Each operation has a pure test (can...) and a change that cannot fail once the test has passed.
// They keep the mesh an oriented two-manifold with the boundaries it has, and move no vertex.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// The vertices opposite to edge (v, u): face (v, u, left) and face (u, v, right). On a boundary
/// one of them is noVertex.
struct OppositeVertices {
    VertexId left;
    VertexId right;
};

/// u must be a neighbour of v.
OppositeVertices oppositeVertices(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Whether edge (v, u) may collapse: the link condition (v and u have just their opposite vertices
/// in common; of a boundary, if both are on one, it is an edge), and their component is no
/// tetrahedron and no single triangle, which stay. False where v and u are no neighbours.
bool canCollapse(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Removes v by collapsing edge (v, u) into u, whose position stays. Requires canCollapse(v, u).
/// Where v is on a boundary, so is u then.
void collapse(NeuralMesh &mesh, VertexId v, VertexId u);

/// In place of a ring place: the gap in the ring of a vertex on a boundary.
inline constexpr int gapPlace = -1;

/// Splits v: the new vertex w, already in the mesh without neighbours, takes the neighbours of v
/// from ring place `first` to `last` counter-clockwise; both of these become neighbours of both.
/// Requires first != last. With a span of s steps between them, w gets valence s + 2 and v keeps
/// valence(v) - s + 2, so v keeps at least 3 where s < valence(v).
///
/// Where v is on a boundary, it stays there. The span may not contain the gap, but may begin or end
/// with it: then w comes to lie next to v on the boundary, one edge of which is (v, w). It gets
/// valence s + 2 and v keeps valence(v) - s + 1, s counted from the first or to the last neighbour.
void split(NeuralMesh &mesh, VertexId v, int first, int last, VertexId w);

/// Whether edge (v, u) may flip: it is none of a boundary, its opposite vertices are not neighbours
/// already, and v and u keep valence 3, on a boundary 2. False where v and u are no neighbours.
bool canFlip(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Replaces edge (v, u) by the edge between its opposite vertices. Requires canFlip(v, u).
void flip(NeuralMesh &mesh, VertexId v, VertexId u);

/// Whether a face may be put on the boundary at v: v lies on one, and the vertices before and after
/// it are no neighbours yet.
bool canCloseOver(const NeuralMesh &mesh, VertexId v);

/// Joins the vertices before and after v on the boundary by a face with v, which leaves the
/// boundary. Requires canCloseOver(v).
void closeOver(NeuralMesh &mesh, VertexId v);

/// Makes mesh.face from the rings, each face once, its lowest id first. Removed vertices' slots
/// stay: compact on the way out.
void rebuildFaces(NeuralMesh &mesh);

/// Turns every ring round: the inside becomes the outside.
void reverseOrientation(NeuralMesh &mesh);

/// Turns a ring round. Those of a whole component are to be turned.
void reverseRing(NeuralMesh &mesh, VertexId v);

} // namespace neuralmesh
