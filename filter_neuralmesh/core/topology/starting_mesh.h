// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh that growth starts from (§3 of the paper: a tetrahedron).
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/parameters.h"

namespace neuralmesh {

/// Makes `mesh` a regular tetrahedron with the given centre and circumradius, oriented outwards.
void makeTetrahedron(NeuralMesh &mesh, const Point3 &centre, Scalar circumradius);

/// Makes `mesh` a platonic solid (not `given`) around the mean of the samples, stretched along
/// their principal axes to one standard deviation. In a long target a regular one has corners that
/// are nearest to no sample. Flat directions are given a hundredth of the diagonal.
void makeStartingSolid(NeuralMesh &mesh, StartMesh solid, const std::vector<Point3> &samples);

} // namespace neuralmesh
