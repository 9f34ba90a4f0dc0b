// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of functions on grids, and from one grid to another.
#pragma once

#include "core/parallel/workers.h"
#include "core/shape/grid.h"

namespace neuralmesh {

/// Nodes from low to high along each axis, both included.
struct NodeBox {
    int low[3];
    int high[3];
};

/// All nodes but those of the border.
NodeBox innerNodes(const Grid &grid);

/// Convolves the nodes of the box, which must be inner ones, with the binomial kernel (1, 2, 1) / 4
/// along each axis, so many times. Nodes around the box stay.
void smooth(Workers &workers, Grid &grid, const NodeBox &box, int times);

/// The grid of twice as many cells, interpolated.
Grid doubled(const Grid &coarse);

/// The grid of half as many cells, of an even number, whose nodes hold the sums of the eight nodes
/// around each.
Grid halvedSums(const Grid &fine);

} // namespace neuralmesh
