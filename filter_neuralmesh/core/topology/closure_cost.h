// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to close a surface that is open.
#pragma once

namespace neuralmesh {

/// Area of a disc over the boundaries of a sheet, in areas of the sheet, from which a second sheet
/// behind the first closes it better. That costs the area of the sheet; a disc, which no sample
/// supports, its own. The disc over half a sphere has half its area, that over a flat sheet all of
/// it.
inline constexpr double largeDisc = 0.7;

} // namespace neuralmesh
