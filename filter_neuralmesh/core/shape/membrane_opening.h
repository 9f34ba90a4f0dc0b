// SPDX-License-Identifier: GPL-3.0-or-later
// Takes out of a closed surface what no point supports.
#pragma once

#include <vector>

#include "core/shape/marching_tetrahedra.h"

namespace neuralmesh {

/// Where a face is far from the points, and from where on it is not near any more. In the unit
/// cube.
struct SupportRadii {
    double near = 0;
    double far = 0;
};

struct MembraneOpening {
    std::vector<Corners> faces; ///< that stay
    int openings = 0;           ///< membranes taken out
};

/// Takes out each membrane: a connected patch of faces that are not near any point, some of them
/// far, and whose area is at least `leastArea`. What stays is a two-manifold with boundaries: of
/// faces that would meet in a vertex only, all but the largest fan go too.
MembraneOpening openMembranes(const TriangleSoup &soup, const std::vector<Point3> &points,
                              const SupportRadii &radii, double leastArea);

} // namespace neuralmesh
