// SPDX-License-Identifier: GPL-3.0-or-later
// From one grid to another.
#pragma once

#include "core/shape/grid.h"

namespace neuralmesh {

/// Convolves the inner nodes with the binomial kernel (1, 2, 1) / 4 along each axis, so many times.
void smooth(Grid &grid, int times);

/// The grid of twice as many cells, interpolated.
Grid doubled(const Grid &coarse);

/// The grid of half as many cells whose nodes hold the sums of the eight nodes around each.
Grid halvedSums(const Grid &fine);

} // namespace neuralmesh
