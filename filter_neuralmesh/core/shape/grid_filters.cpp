// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/grid_filters.h"

#include <algorithm>
#include <vector>

#include "core/shape/grid_loops.h"

namespace neuralmesh {
namespace {

/// Rows of nodes along z, `count` long. `before` are the old values of the row before this one; the
/// old values of this one take their place.
void smoothRow(float *__restrict row, const float *__restrict after, float *__restrict before,
               int count)
{
    for (int z = 0; z < count; ++z) {
        const float here = row[z];
        row[z] = 0.25F * (before[z] + after[z]) + 0.5F * here;
        before[z] = here;
    }
}

/// `row` has a node before the first and one after the last.
void smoothAlong(float *__restrict row, float *__restrict old, int count)
{
    std::copy(row - 1, row + count + 1, old);
    for (int z = 0; z < count; ++z)
        row[z] = 0.25F * (old[z] + old[z + 2]) + 0.5F * old[z + 1];
}

/// `first` is the first of `rows` rows that follow each other by `stride`.
void smoothAcross(float *first, std::ptrdiff_t stride, int rows, float *before, int count)
{
    std::copy(first - stride, first - stride + count, before);
    for (int i = 0; i < rows; ++i)
        smoothRow(first + i * stride, first + (i + 1) * stride, before, count);
}

} // namespace

NodeBox innerNodes(const Grid &grid)
{
    const GridSize &cells = grid.cells();
    return {{1, 1, 1}, {cells.x - 1, cells.y - 1, cells.z - 1}};
}

void smooth(Workers &workers, Grid &grid, const NodeBox &box, int times)
{
    const int count = box.high[2] - box.low[2] + 1;
    const int rows[] = {box.high[0] - box.low[0] + 1, box.high[1] - box.low[1] + 1};
    const auto withScratch = [&](int axis, const auto &visit) {
        const int from = box.low[axis];
        const std::size_t together = 1 + nodesOfChunk / (static_cast<std::size_t>(rows[1 - axis]) *
                                                         static_cast<std::size_t>(count));
        workers.forEachChunk(static_cast<std::size_t>(rows[axis]), together,
                             [&](std::size_t first, std::size_t end, int) {
                                 std::vector<float> scratch(static_cast<std::size_t>(count) + 2);
                                 for (std::size_t i = first; i < end; ++i)
                                     visit(from + static_cast<int>(i), scratch.data());
                             });
    };
    for (int pass = 0; pass < times; ++pass) {
        withScratch(0, [&](int x, float *scratch) {
            for (int y = box.low[1]; y <= box.high[1]; ++y)
                smoothAlong(grid.data() + grid.index(x, y, box.low[2]), scratch, count);
            smoothAcross(grid.data() + grid.index(x, box.low[1], box.low[2]), grid.strideY(),
                         rows[1], scratch, count);
        });
        withScratch(1, [&](int y, float *scratch) {
            smoothAcross(grid.data() + grid.index(box.low[0], y, box.low[2]), grid.strideX(),
                         rows[0], scratch, count);
        });
    }
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
    Grid coarse({cells.x / 2, cells.y / 2, cells.z / 2});
    for (int x = 0; x <= cells.x; ++x)
        for (int y = 0; y <= cells.y; ++y)
            for (int z = 0; z <= cells.z; ++z)
                coarse.at((x + 1) / 2, (y + 1) / 2, (z + 1) / 2) += fine.at(x, y, z);
    return coarse;
}

} // namespace neuralmesh
