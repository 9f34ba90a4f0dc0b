// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of a grid as spans of its rows. A surface passes near one node in ten of a grid of 128
// cells, and near one in twenty of one of 256: what is done at these alone is cheap.
#pragma once

#include <cstdint>
#include <vector>

#include "core/parallel/workers.h"
#include "core/shape/grid.h"
#include "core/shape/grid_loops.h"

namespace neuralmesh {

/// Inner nodes, as spans of z of each row (x, y).
class NodeSpans {
public:
    NodeSpans() = default;

    /// All inner nodes.
    explicit NodeSpans(const GridSize &cells);

    /// The inner nodes up to so many nodes along each axis from these cells' corners. A cell is
    /// told by its lowest node; they are in ascending order, and none is at the border.
    NodeSpans(const GridSize &cells, const std::vector<std::uint32_t> &around, int distance);

    /// These and the inner nodes beside them along an axis.
    NodeSpans widened() const;

    /// All other inner nodes.
    NodeSpans complement() const;

    /// The inner nodes of the grid of half as many cells that are on one of these or beside one,
    /// along an axis or a diagonal.
    NodeSpans halved() const;

    /// How many nodes.
    std::size_t size() const { return size_; }

    /// Calls visit(low, end) for the spans z = low ... end - 1 of a row, in ascending order. They
    /// do not touch.
    template <class Visit> void forEachInRow(int x, int y, const Visit &visit) const
    {
        const std::size_t row = rowOf(x, y);
        for (std::uint32_t i = firstOfRow_[row]; i < firstOfRow_[row + 1]; ++i)
            visit(spans_[i].low, spans_[i].end);
    }

    /// Calls visit(x, y, low, end) for all spans, on the workers' threads. What one call writes, no
    /// other may read.
    template <class Visit> void forEach(Workers &workers, const Visit &visit) const
    {
        if (size_ == 0)
            return;
        const auto planes = static_cast<std::size_t>(cells_.x) - 1;
        const std::size_t together = 1 + nodesOfChunk * planes / size_;
        workers.forEachChunk(planes, together, [&](std::size_t first, std::size_t end, int) {
            for (std::size_t plane = first; plane < end; ++plane) {
                const int x = 1 + static_cast<int>(plane);
                for (int y = 1; y < cells_.y; ++y)
                    forEachInRow(x, y, [&](int low, int last) { visit(x, y, low, last); });
            }
        });
    }

private:
    struct Span {
        int low, end;
    };

    template <class Rows> static NodeSpans united(const GridSize &cells, const Rows &rows);

    std::size_t rowOf(int x, int y) const
    {
        return static_cast<std::size_t>(x) * (static_cast<std::size_t>(cells_.y) + 1) +
               static_cast<std::size_t>(y);
    }

    GridSize cells_;
    std::vector<Span> spans_;               ///< row by row
    std::vector<std::uint32_t> firstOfRow_; ///< and, last, how many there are
    std::size_t size_ = 0;
};

} // namespace neuralmesh
