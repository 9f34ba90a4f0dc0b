// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of least weight of a closed loop of edges in space.
//
// Barequet, Sharir: Filling gaps in the boundary of a polyhedron (CAGD 1995); Liepa: Filling holes
// in meshes (SGP 2003). Their weights are areas and angles; here the caller weighs.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <vector>

namespace neuralmesh {

/// Places in the loop, ascending.
using LoopTriangle = std::array<int, 3>;

struct LoopTriangulation {
    std::vector<LoopTriangle> triangles; ///< size - 2 of them; none where no triangulation exists
    double weight = std::numeric_limits<double>::infinity(); ///< the sum over the triangles
};

/// For a loop of `size` >= 3 corners. `weight(i, j, k)` is that of a triangle, i < j < k; one that
/// is infinite forbids it. Time grows with size³, memory with size².
LoopTriangulation triangulateLoop(int size,
                                  const std::function<double(int, int, int)> &weightOfTriangle);

} // namespace neuralmesh
