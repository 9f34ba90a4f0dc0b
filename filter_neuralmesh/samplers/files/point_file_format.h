// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samplers/files/point_layout.h"

namespace neuralmesh {

/// The layout of a point file of any format that is read in place, told by its first bytes, not by
/// its name. It passes requireRoom(): its records can be read. Throws InvalidInput, with a sentence
/// that starts in lower case to be put behind the file's name, for broken files and for other
/// formats; for LAZ and E57 it says what to convert them with.
PointLayout readPointLayout(Bytes file);

} // namespace neuralmesh
