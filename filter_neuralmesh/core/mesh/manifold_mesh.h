// SPDX-License-Identifier: GPL-3.0-or-later
// From a list of faces to the network's neighbour rings.
#pragma once

#include <vector>

#include "core/mesh/face_table.h"
#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Whether a mesh may have edges that belong to one face only.
enum class Boundaries { refused, allowed };

/// Makes `mesh` the two-manifold of these faces; points that no face names are left out. It may
/// have handles and several components. Faces that agree on their orientation keep it; in a
/// component where they do not, all are turned outwards, or if it is open, like the first.
///
/// Throws InvalidStartingMesh where there are no faces, a face names a vertex twice, an edge
/// belongs to more than two faces or, where boundaries are refused, to one, two faces of a closed
/// component have the same three corners, a vertex joins several fans of faces, or no orientation
/// agrees (a Klein bottle).
void makeManifold(NeuralMesh &mesh, const std::vector<Point3> &points,
                  const std::vector<Corners> &faces, Boundaries boundaries = Boundaries::refused);

} // namespace neuralmesh
