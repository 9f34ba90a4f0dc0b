// SPDX-License-Identifier: GPL-3.0-or-later
// The surface where a function on a grid has a value.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/face_table.h"
#include "core/shape/grid.h"

namespace neuralmesh {

struct TriangleSoup {
    std::vector<Point3> points;
    std::vector<Corners> faces;
};

/// The lowest nodes of the cells that surfaces of some levels in [low, high] pass through, in their
/// order in memory.
std::vector<std::uint32_t> cellsBetween(const Grid &f, float low, float high);

/// The boundary of {f > level}, by marching tetrahedra: six to a cell, the same way in all cells
/// (Kuhn's subdivision), so that the surface is a closed two-manifold, oriented outwards. Points in
/// the grid's box. f must not be above the level at the border of the grid. `cells` must be among
/// cellsBetween() of levels around this one.
TriangleSoup marchTetrahedra(const Grid &f, float level, const std::vector<std::uint32_t> &cells);

} // namespace neuralmesh
