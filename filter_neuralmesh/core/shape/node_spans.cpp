// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/node_spans.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// The nodes of one row, out of spans that may overlap.
class RowUnion {
public:
    explicit RowUnion(int cells) : cells_(cells), isIn_(static_cast<std::size_t>(cells) + 1, 0) {}

    void add(int low, int end)
    {
        low = std::max(low, 1);
        end = std::min(end, cells_);
        if (low >= end)
            return;
        std::fill(isIn_.data() + low, isIn_.data() + end, static_cast<unsigned char>(1));
        low_ = std::min(low_, low);
        end_ = std::max(end_, end);
    }

    /// Calls visit(low, end) for the spans that are left, and forgets them.
    template <class Visit> void take(const Visit &visit)
    {
        for (int z = low_; z < end_;) {
            const int low = z;
            while (isIn_[static_cast<std::size_t>(z)] != 0)
                isIn_[static_cast<std::size_t>(z++)] = 0;
            visit(low, z);
            while (z < end_ && isIn_[static_cast<std::size_t>(z)] == 0)
                ++z;
        }
        low_ = cells_;
        end_ = 0;
    }

private:
    int cells_;
    std::vector<unsigned char> isIn_; ///< by z; the last, of the border, ends each span
    int low_ = cells_;
    int end_ = 0;
};

} // namespace

/// Each inner row from the spans that rows(x, y, add) adds by calls of add(low, end).
template <class Rows> NodeSpans NodeSpans::united(const GridSize &cells, const Rows &rows)
{
    NodeSpans nodes;
    nodes.cells_ = cells;
    nodes.firstOfRow_.assign(nodes.rowOf(cells.x + 1, 0) + 1, 0);
    RowUnion row(cells.z);
    for (int x = 0; x <= cells.x; ++x)
        for (int y = 0; y <= cells.y; ++y) {
            if (x > 0 && x < cells.x && y > 0 && y < cells.y)
                rows(x, y, [&](int low, int end) { row.add(low, end); });
            row.take([&](int low, int end) {
                nodes.spans_.push_back({low, end});
                nodes.size_ += static_cast<std::size_t>(end - low);
            });
            nodes.firstOfRow_[nodes.rowOf(x, y) + 1] =
                static_cast<std::uint32_t>(nodes.spans_.size());
        }
    return nodes;
}

NodeSpans::NodeSpans(const GridSize &cells)
    : NodeSpans(united(cells, [&](int, int, const auto &add) { add(1, cells.z); }))
{
}

NodeSpans::NodeSpans(const GridSize &cells, const std::vector<std::uint32_t> &around, int distance)
{
    const auto columns = static_cast<std::uint32_t>(cells.z) + 1;
    auto next = around.begin();
    const NodeSpans corners = united(cells, [&](int x, int y, const auto &add) {
        const auto row = static_cast<std::uint32_t>(x * (cells.y + 1) + y) * columns;
        next = std::lower_bound(next, around.end(), row);
        for (; next != around.end() && *next < row + columns; ++next)
            add(static_cast<int>(*next - row), static_cast<int>(*next - row) + 2);
    });
    // From the lowest node of a cell to both sides of it.
    const NodeSpans planes = united(cells, [&](int x, int y, const auto &add) {
        const int last = std::min(y + distance, cells.y);
        for (int from = std::max(y - distance - 1, 0); from <= last; ++from)
            corners.forEachInRow(x, from,
                                 [&](int low, int end) { add(low - distance, end + distance); });
    });
    *this = united(cells, [&](int x, int y, const auto &add) {
        const int last = std::min(x + distance, cells.x);
        for (int from = std::max(x - distance - 1, 0); from <= last; ++from)
            planes.forEachInRow(from, y, add);
    });
}

NodeSpans NodeSpans::widened() const
{
    return united(cells_, [&](int x, int y, const auto &add) {
        forEachInRow(x, y, [&](int low, int end) { add(low - 1, end + 1); });
        forEachInRow(x - 1, y, add);
        forEachInRow(x + 1, y, add);
        forEachInRow(x, y - 1, add);
        forEachInRow(x, y + 1, add);
    });
}

NodeSpans NodeSpans::complement() const
{
    return united(cells_, [&](int x, int y, const auto &add) {
        int from = 1;
        forEachInRow(x, y, [&](int low, int end) {
            add(from, low);
            from = end;
        });
        add(from, cells_.z);
    });
}

NodeSpans NodeSpans::halved() const
{
    const GridSize half = cells_.halved();
    return united(half, [&](int x, int y, const auto &add) {
        for (int i = 2 * x - 1; i <= 2 * x + 1; ++i)
            for (int j = 2 * y - 1; j <= 2 * y + 1; ++j)
                forEachInRow(i, j, [&](int low, int end) { add(low / 2, end / 2 + 1); });
    });
}

} // namespace neuralmesh
