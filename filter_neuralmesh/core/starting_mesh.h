// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh that growth starts from (§3 of the paper: a tetrahedron).
#pragma once

#include "neural_mesh.h"

namespace neuralmesh {

/// Makes `mesh` a regular tetrahedron with the given centre and circumradius, oriented outwards.
void makeTetrahedron(NeuralMesh& mesh, const Point3& centre, Scalar circumradius);

} // namespace neuralmesh
