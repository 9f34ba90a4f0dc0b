// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samplers/files/point_layout.h"

namespace neuralmesh {

/// Whether the file starts as a LAS or LAZ file does.
bool isLas(Bytes file);

/// The layout of a LAS file, versions 1.0 to 1.4 (ASPRS, LAS Specification 1.4 R15), point formats
/// 0 to 10, and the bounds that its header claims, where they are finite and in order. Sizes are
/// not checked against the file: requireRoom() does that. Throws InvalidInput where the header is
/// broken or the points are compressed (LAZ).
PointLayout readLasHeader(Bytes file);

} // namespace neuralmesh
