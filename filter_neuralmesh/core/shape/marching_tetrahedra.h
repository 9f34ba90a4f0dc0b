// SPDX-License-Identifier: GPL-3.0-or-later
// The surface where a function on a grid is zero.
#pragma once

#include <vector>

#include "core/mesh/face_table.h"
#include "core/shape/grid.h"

namespace neuralmesh {

struct TriangleSoup {
    std::vector<Point3> points;
    std::vector<Corners> faces;
};

/// The boundary of {f > 0}, by marching tetrahedra: six to a cell, the same way in all cells
/// (Kuhn's subdivision), so that the surface is a closed two-manifold, oriented outwards. Points in
/// the unit cube. f must not be positive at the border of the grid.
TriangleSoup marchTetrahedra(const Grid &f);

} // namespace neuralmesh
