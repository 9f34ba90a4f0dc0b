// SPDX-License-Identifier: GPL-3.0-or-later
// Takes out of a closed surface what no point supports.
#pragma once

#include <vector>

#include "core/shape/surface_support.h"

namespace neuralmesh {

struct MembraneOpening {
    std::vector<Corners> faces; ///< that stay
    int openings = 0;           ///< membranes taken out
};

/// Takes out each membrane: a connected patch of faces that are not near any point, some of them
/// far, and whose area is at least `leastArea`. What stays is a two-manifold with boundaries: of
/// faces that would meet in a vertex only, all but the largest fan go too.
MembraneOpening openMembranes(const TriangleSoup &soup, const std::vector<Support> &support,
                              double leastArea);

} // namespace neuralmesh
