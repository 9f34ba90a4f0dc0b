// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over a grid that several threads share.
#pragma once

#include "core/parallel/workers.h"
#include "core/shape/grid.h"

namespace neuralmesh {

/// Nodes that are worth a thread's while.
inline constexpr std::size_t nodesOfChunk = 30000;

/// Calls visit(first, end) for ranges of the planes x = low ... high of a grid.
template <class Visit>
void forEachPlanes(Workers &workers, const Grid &grid, int low, int high, const Visit &visit)
{
    const std::size_t planes = 1 + nodesOfChunk / static_cast<std::size_t>(grid.strideX());
    workers.forEachChunk(static_cast<std::size_t>(high - low) + 1, planes,
                         [&](std::size_t first, std::size_t end, int) {
                             visit(low + static_cast<int>(first), low + static_cast<int>(end));
                         });
}

} // namespace neuralmesh
