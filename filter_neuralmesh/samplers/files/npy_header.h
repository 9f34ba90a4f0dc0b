// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samplers/files/point_layout.h"

namespace neuralmesh {

/// Whether the file starts as a NumPy array file does.
bool isNpy(Bytes file);

/// The layout of a NumPy array file (.npy, versions 1 to 3 of its format) that holds N by 3
/// float32 or float64 numbers of either byte order in C order. Sizes are not checked against the
/// file: requireRoom() does that. Throws InvalidInput where the header is broken or the array is
/// another one.
PointLayout readNpyHeader(Bytes file);

} // namespace neuralmesh
