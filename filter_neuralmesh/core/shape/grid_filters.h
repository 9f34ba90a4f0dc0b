// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of functions on grids, and from one grid to another.
#pragma once

#include "core/parallel/workers.h"
#include "core/shape/grid.h"
#include "core/shape/node_spans.h"

namespace neuralmesh {

/// Gives these nodes a value.
void fill(Workers &workers, Grid &grid, const NodeSpans &nodes, float value);

/// Convolves these nodes with the binomial kernel (1, 2, 1) / 4 along each axis, so many times, as
/// if all other nodes were 0. These stay. Wide kernels are those of coarser grids, interpolated:
/// the work is that of a few passes however many there are.
void smooth(Workers &workers, Grid &grid, const NodeSpans &nodes, int times);

/// The grid of twice as many cells, interpolated.
Grid doubled(const Grid &coarse);

/// The grid of half as many cells, of an even number, whose nodes hold the sums of the eight nodes
/// around each.
Grid halvedSums(const Grid &fine);

/// The same, of a grid that is 0 at all nodes but these.
Grid halvedSums(const Grid &fine, const NodeSpans &nodes);

} // namespace neuralmesh
