// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of a surface points support.
#pragma once

#include <vector>

#include "core/shape/marching_tetrahedra.h"
#include "core/space/point_index.h"

namespace neuralmesh {

/// Where a face is far from the points, and from where on it is not near any more. In the unit of
/// the surface.
struct SupportRadii {
    double near = 0;
    double far = 0;
};

enum class Support : unsigned char { near, notNear, far };

struct SurfaceSupport {
    std::vector<Support> ofFace;
    /// Share of the area that is far from all points.
    double farShare = 0;
};

double areaOf(const TriangleSoup &soup);

/// A face is as far from the points as its centre.
SurfaceSupport measureSupport(const TriangleSoup &soup, const PointIndex &points,
                              const SupportRadii &radii);

} // namespace neuralmesh
