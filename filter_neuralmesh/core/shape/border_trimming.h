// SPDX-License-Identifier: GPL-3.0-or-later
// Takes off the borders of a surface what reaches beyond the points.
#pragma once

#include <vector>

#include "core/shape/marching_tetrahedra.h"
#include "core/space/point_index.h"

namespace neuralmesh {

/// How far from its centre a face's points are looked for. In the unit of the surface.
struct TrimmingRadii {
    double away = 0;  ///< in all
    double along = 0; ///< along the face
};

/// The faces of a two-manifold without those that lie beyond the points, from its borders inwards,
/// as long as that tears nothing off and pinches nothing: parts, handles and borders stay as many.
std::vector<Corners> trimBorders(const TriangleSoup &soup, const PointIndex &points,
                                 const TrimmingRadii &radii);

} // namespace neuralmesh
