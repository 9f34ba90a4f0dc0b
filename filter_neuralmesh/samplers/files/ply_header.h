// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samplers/files/point_layout.h"

namespace neuralmesh {

/// Whether the file starts as a PLY file does.
bool isPly(Bytes file);

/// The layout of the element "vertex" of a binary PLY file (Turk 1994) of either byte order, with
/// x, y and z of type float or double among properties of any fixed size. What follows the vertices
/// is ignored. Sizes are not checked against the file: requireRoom() does that. Throws InvalidInput
/// where the header is broken, the file is text, or lists make the place of a vertex unknown.
PointLayout readPlyHeader(Bytes file);

} // namespace neuralmesh
