// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Which of some points are of a sparser part of the data, and no strays: by point, how far from it
/// others are that belong to the same part, or 0 where it is a stray. The points are those that
/// stand alone, and all others whose spacing is like theirs.
///
/// A point of a surface has its neighbours in a plane, one of a wire in a line, at its own spacing;
/// strays have theirs in all directions. Directions tell that whatever the distances: of a few
/// strays, some are orders further off than others, and any measure that weighs by distance takes
/// these for a line or a plane. One point may be in a plane with its neighbours by chance, and a
/// few neighbours: most of these have to be so as well. Of up to eight points there is no telling;
/// they are strays.
///
/// In a thin limb or a narrow fold, no point has its neighbours in a plane. It is a part where most
/// points of its spacing are: strays that fill space as densely as points lie on a surface would
/// outnumber these.
std::vector<double> reachesInSparseParts(const std::vector<Point3> &sparse);

} // namespace neuralmesh
