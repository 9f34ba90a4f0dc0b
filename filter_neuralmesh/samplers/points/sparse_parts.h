// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/space/point_tree.h"

namespace neuralmesh {

/// What of the points that stand alone is a part of the data all the same, only a sparser one: by
/// point, how far from it others are that belong to the same part, or 0 where it is a stray.
///
/// A point of a surface has its neighbours in a plane, one of a wire in a line, at its own spacing;
/// strays have theirs in all directions. Directions tell that whatever the distances: of a few
/// strays, some are orders further off than others, and any measure that weighs by distance takes
/// these for a line or a plane. One point may be in a plane with its neighbours by chance, and a
/// few neighbours: most of these, and of theirs, have to be so as well. Of up to eight points there
/// is no telling; they are strays.
///
/// Others are at the spacing of all points, of which those that stand alone are a part: the border
/// of a dense surface has some, far from each other.
std::vector<double> reachesInSparseParts(const std::vector<Point3> &alone, PointTree &all);

} // namespace neuralmesh
