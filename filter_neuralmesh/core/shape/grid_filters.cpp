// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/grid_filters.h"

#include <algorithm>
#include <vector>

#include "core/shape/grid_loops.h"

namespace neuralmesh {
namespace {

/// Passes that a grid has itself. The kernel of more is wider than two cells of the grid of half as
/// many, by its standard deviation, and interpolated there to a tenth of its peak. A quarter of the
/// passes has that width there, and each takes an eighth of the time.
constexpr int mostPasses = 32;

/// Adds the nodes of a span to those of the coarse grid.
void addHalved(const Grid &fine, int x, int y, int low, int end, Grid &coarse)
{
    const float *from = fine.data() + fine.index(x, y, 0);
    float *to = coarse.data() + coarse.index((x + 1) / 2, (y + 1) / 2, 0);
    for (int z = low; z < end; ++z)
        to[(z + 1) / 2] += from[z];
}

/// Rows of nodes along z side by side, all of which are 0 but the chosen ones. What all passes read
/// and write stays in cache.
class Slab {
public:
    Slab(int rows, int columns)
        : rows_(rows), columns_(columns),
          now_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), 0), next_(now_)
    {
    }

    /// The rows from `first` on follow each other by a stride; spansOf(row, visit) calls
    /// visit(low, end) for the chosen nodes of one, which are none of the first and of the last.
    template <class Spans>
    void smooth(float *first, std::ptrdiff_t stride, const Spans &spansOf, bool isAlongZ, int times)
    {
        const auto forEachSpan = [&](const auto &visit) {
            for (int row = 1; row < rows_ - 1; ++row)
                spansOf(row, [&](int low, int end) {
                    visit(first + row * stride + low, std::ptrdiff_t(row) * columns_ + low,
                          std::ptrdiff_t(end) - low);
                });
        };
        const auto mix = [&](std::ptrdiff_t step) {
            forEachSpan([&](const float *, std::ptrdiff_t i, std::ptrdiff_t count) {
                mixSpan(now_.data() + i, step, count, next_.data() + i);
            });
            std::swap(now_, next_);
        };
        forEachSpan([&](const float *nodes, std::ptrdiff_t i, std::ptrdiff_t count) {
            std::copy(nodes, nodes + count, now_.data() + i);
        });
        for (int pass = 0; pass < times; ++pass) {
            if (isAlongZ)
                mix(1);
            mix(columns_);
        }
        forEachSpan([&](float *nodes, std::ptrdiff_t i, std::ptrdiff_t count) {
            std::copy_n(now_.data() + i, count, nodes);
            std::fill_n(now_.data() + i, count, 0.0F);
            std::fill_n(next_.data() + i, count, 0.0F);
        });
    }

private:
    static void mixSpan(const float *__restrict now, std::ptrdiff_t step, std::ptrdiff_t count,
                        float *__restrict next)
    {
        for (std::ptrdiff_t i = 0; i < count; ++i)
            next[i] = 0.25F * (now[i - step] + now[i + step]) + 0.5F * now[i];
    }

    int rows_, columns_;
    std::vector<float> now_, next_;
};

} // namespace

void fill(Workers &workers, Grid &grid, const NodeSpans &nodes, float value)
{
    nodes.forEach(workers, [&](int x, int y, int low, int end) {
        std::fill_n(grid.data() + grid.index(x, y, low), end - low, value);
    });
}

namespace {

void smoothOnGrid(Workers &workers, Grid &grid, const NodeSpans &nodes, int times)
{
    const GridSize &cells = grid.cells();
    const auto withSlabs = [&](int planes, int rows, const auto &visit) {
        const std::size_t count = static_cast<std::size_t>(planes) - 1;
        const std::size_t together = 1 + nodesOfChunk * count / (nodes.size() + 1);
        workers.forEachChunk(count, together, [&](std::size_t first, std::size_t end, int) {
            Slab slab(rows + 1, cells.z + 1);
            for (std::size_t i = first; i < end; ++i)
                visit(slab, static_cast<int>(i) + 1);
        });
    };
    withSlabs(cells.x, cells.y, [&](Slab &slab, int x) {
        const auto spansOf = [&](int y, const auto &visit) { nodes.forEachInRow(x, y, visit); };
        slab.smooth(grid.data() + grid.index(x, 0, 0), grid.strideY(), spansOf, true, times);
    });
    withSlabs(cells.y, cells.x, [&](Slab &slab, int y) {
        const auto spansOf = [&](int x, const auto &visit) { nodes.forEachInRow(x, y, visit); };
        slab.smooth(grid.data() + grid.index(0, y, 0), grid.strideX(), spansOf, false, times);
    });
}

/// Every second of these nodes along each axis; 0 elsewhere.
Grid everySecond(const Grid &fine, const NodeSpans &nodes)
{
    Grid coarse(fine.cells().halved());
    for (int x = 2; x < fine.cells().x; x += 2)
        for (int y = 2; y < fine.cells().y; y += 2)
            nodes.forEachInRow(x, y, [&](int low, int end) {
                for (int z = (low + 1) / 2; 2 * z < end; ++z)
                    coarse.at(x / 2, y / 2, z) = fine.at(x, y, 2 * z);
            });
    return coarse;
}

} // namespace

void smooth(Workers &workers, Grid &grid, const NodeSpans &nodes, int times)
{
    if (times <= mostPasses || !grid.cells().canHalve())
        return smoothOnGrid(workers, grid, nodes, times);
    // The interpolation is as wide as a pass; and one before makes the whole its own adjoint.
    const int coarsePasses = (times - 2) / 4;
    smoothOnGrid(workers, grid, nodes, times - 1 - 4 * coarsePasses);
    Grid coarse = everySecond(grid, nodes);
    smooth(workers, coarse, nodes.halved(), coarsePasses);
    const Grid wide = doubled(coarse);
    nodes.forEach(workers, [&](int x, int y, int low, int end) {
        std::copy_n(wide.data() + wide.index(x, y, low), end - low,
                    grid.data() + grid.index(x, y, low));
    });
}

Grid doubled(const Grid &coarse)
{
    Grid fine(coarse.cells().doubled());
    const std::ptrdiff_t sx = coarse.strideX();
    const std::ptrdiff_t sy = coarse.strideY();
    const int columns = coarse.cells().z;
    std::vector<float> mean(static_cast<std::size_t>(columns) + 1);
    for (int x = 0; x <= fine.cells().x; ++x)
        for (int y = 0; y <= fine.cells().y; ++y) {
            const float *low = coarse.data() + coarse.index(x / 2, y / 2, 0);
            const std::ptrdiff_t dx = (x & 1) != 0 ? sx : 0;
            const std::ptrdiff_t dy = (y & 1) != 0 ? sy : 0;
            for (int z = 0; z <= columns; ++z)
                mean[static_cast<std::size_t>(z)] =
                    0.25F * (low[z] + low[z + dx] + low[z + dy] + low[z + dx + dy]);
            float *row = fine.data() + fine.index(x, y, 0);
            for (std::ptrdiff_t z = 0; z < columns; ++z) {
                const float *here = mean.data() + z;
                row[2 * z] = here[0];
                row[2 * z + 1] = 0.5F * (here[0] + here[1]);
            }
            row[std::ptrdiff_t(2) * columns] = mean.back();
        }
    return fine;
}

Grid halvedSums(const Grid &fine)
{
    const GridSize &cells = fine.cells();
    Grid coarse(cells.halved());
    for (int x = 0; x <= cells.x; ++x)
        for (int y = 0; y <= cells.y; ++y)
            addHalved(fine, x, y, 0, cells.z + 1, coarse);
    return coarse;
}

Grid halvedSums(const Grid &fine, const NodeSpans &nodes)
{
    const GridSize &cells = fine.cells();
    Grid coarse(cells.halved());
    for (int x = 1; x < cells.x; ++x)
        for (int y = 1; y < cells.y; ++y)
            nodes.forEachInRow(x, y,
                               [&](int low, int end) { addHalved(fine, x, y, low, end, coarse); });
    return coarse;
}

} // namespace neuralmesh
