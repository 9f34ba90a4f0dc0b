// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/grid_filters.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Along z, within a row.
void smoothRow(float *row, int last)
{
    float before = row[0];
    for (int z = 1; z < last; ++z) {
        const float here = row[z];
        row[z] = 0.25F * (before + row[z + 1]) + 0.5F * here;
        before = here;
    }
}

/// Along x or y, a row at a time: `row(i)` is the i-th of those that follow each other.
template <class Row>
void smoothAcross(Row row, std::ptrdiff_t stride, int last, std::vector<float> &before)
{
    std::fill(before.begin(), before.end(), 0.0F);
    for (int i = 1; i < last; ++i) {
        float *values = row(i);
        float *old = before.data();
        for (int z = 1; z < last; ++z) {
            const float here = values[z];
            values[z] = 0.25F * (old[z] + values[z + stride]) + 0.5F * here;
            old[z] = here;
        }
    }
}

} // namespace

void smooth(Grid &grid, int times)
{
    const int last = grid.cells();
    std::vector<float> before(static_cast<std::size_t>(last));
    for (int pass = 0; pass < times; ++pass) {
        for (int x = 1; x < last; ++x)
            for (int y = 1; y < last; ++y)
                smoothRow(grid.data() + grid.index(x, y, 0), last);
        for (int x = 1; x < last; ++x)
            smoothAcross([&](int y) { return grid.data() + grid.index(x, y, 0); }, grid.strideY(),
                         last, before);
        for (int y = 1; y < last; ++y)
            smoothAcross([&](int x) { return grid.data() + grid.index(x, y, 0); }, grid.strideX(),
                         last, before);
    }
}

Grid doubled(const Grid &coarse)
{
    Grid fine(2 * coarse.cells());
    const int last = fine.cells();
    for (int x = 0; x <= last; ++x)
        for (int y = 0; y <= last; ++y)
            for (int z = 0; z <= last; ++z) {
                const int x0 = x / 2, y0 = y / 2, z0 = z / 2;
                const int x1 = (x + 1) / 2, y1 = (y + 1) / 2, z1 = (z + 1) / 2;
                fine.at(x, y, z) =
                    (coarse.at(x0, y0, z0) + coarse.at(x0, y0, z1) + coarse.at(x0, y1, z0) +
                     coarse.at(x0, y1, z1) + coarse.at(x1, y0, z0) + coarse.at(x1, y0, z1) +
                     coarse.at(x1, y1, z0) + coarse.at(x1, y1, z1)) /
                    8;
            }
    return fine;
}

Grid halvedSums(const Grid &fine)
{
    Grid coarse(fine.cells() / 2);
    const int last = fine.cells();
    for (int x = 0; x <= last; ++x)
        for (int y = 0; y <= last; ++y)
            for (int z = 0; z <= last; ++z)
                coarse.at((x + 1) / 2, (y + 1) / 2, (z + 1) / 2) += fine.at(x, y, z);
    return coarse;
}

} // namespace neuralmesh
