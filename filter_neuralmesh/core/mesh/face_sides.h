// SPDX-License-Identifier: GPL-3.0-or-later
// The sides of faces in a list, brought together edge by edge.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/mesh/face_table.h"

namespace neuralmesh {

/// One face's side of an edge: from a corner to the next.
struct FaceSide {
    VertexId low, high; ///< the edge's ends
    FaceId face;
    unsigned corner;
    bool isRising; ///< runs from low to high
};

/// By low, then high, then face. In linear time where no vertex has many neighbours.
std::vector<FaceSide> sidesByEdge(const std::vector<Corners> &faces);

/// The faces for which `stays` holds.
std::vector<Corners> kept(const std::vector<Corners> &faces, const std::vector<bool> &stays);

/// By face: the faces across its three sides, or noFace. No edge may have more than two faces.
std::vector<std::array<FaceId, 3>> facesAcross(const std::vector<Corners> &faces);

} // namespace neuralmesh
