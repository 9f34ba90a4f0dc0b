// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/poisson_multigrid.h"

#include <algorithm>
#include <utility>

#include "core/shape/grid_loops.h"

namespace neuralmesh {
namespace {

/// The coarsest grid has so few cells along its shortest axis, and these sweeps solve it.
constexpr int coarsestCells = 4;
constexpr int coarsestSweeps = 16;

/// Weights of two steps of Jacobi's method that damp best, together, what a coarser grid cannot
/// represent: the eigenvalues of the Laplacian over its diagonal from 1/3 to 2. They are the
/// inverse roots of Chebyshev's polynomial of degree 2 over that interval.
constexpr float firstWeight = 1.7318F;
constexpr float secondWeight = 0.5695F;

/// Grids of so many cells and more are worked on around the sources alone: of smaller ones, these
/// are half and more.
constexpr int sparseCells = 64;

/// A step of Jacobi's method at a span of a row; sx and sy lead to the neighbouring rows.
void relaxSpan(const float *__restrict u, const float *__restrict f, std::ptrdiff_t sx,
               std::ptrdiff_t sy, int low, int end, float weight, float *__restrict next)
{
    const float kept = 1 - weight;
    const float share = weight / 6;
    for (int z = low; z < end; ++z)
        next[z] = kept * u[z] + share * (f[z] + u[z - sx] + u[z + sx] + u[z - sy] + u[z + sy] +
                                         u[z - 1] + u[z + 1]);
}

void residualSpan(const float *__restrict u, const float *__restrict f, std::ptrdiff_t sx,
                  std::ptrdiff_t sy, int low, int end, float *__restrict r)
{
    for (int z = low; z < end; ++z)
        r[z] =
            f[z] - 6 * u[z] + u[z - sx] + u[z + sx] + u[z - sy] + u[z + sy] + u[z - 1] + u[z + 1];
}

void clearHeld(const Grid &isFree, std::size_t row, int low, int end, float *__restrict values)
{
    if (isFree.isEmpty())
        return;
    const float *__restrict free = isFree.data() + row;
    for (int z = low; z < end; ++z)
        values[z] *= free[z];
}

void relax(Workers &workers, const NodeSpans &nodes, const Grid &u, const Grid &f,
           const Grid &isFree, float weight, Grid &next)
{
    nodes.forEach(workers, [&](int x, int y, int low, int end) {
        const std::size_t row = u.index(x, y, 0);
        relaxSpan(u.data() + row, f.data() + row, u.strideX(), u.strideY(), low, end, weight,
                  next.data() + row);
        clearHeld(isFree, row, low, end, next.data() + row);
    });
}

/// Gauss and Seidel's method, for grids that are so small that order costs nothing.
void sweep(Grid &u, const Grid &f, const Grid &isFree, int times)
{
    const std::ptrdiff_t sx = u.strideX();
    const std::ptrdiff_t sy = u.strideY();
    for (int i = 0; i < times; ++i)
        forEachInnerRow(u, [&](std::size_t row) {
            float *v = u.data() + row;
            const float *s = f.data() + row;
            for (int z = 1; z < u.cells().z; ++z) {
                v[z] =
                    (s[z] + v[z - sx] + v[z + sx] + v[z - sy] + v[z + sy] + v[z - 1] + v[z + 1]) *
                    (1.0F / 6);
                if (!isFree.isEmpty())
                    v[z] *= isFree[row + static_cast<std::size_t>(z)];
            }
        });
}

void computeResidual(Workers &workers, const NodeSpans &nodes, const Grid &u, const Grid &f,
                     const Grid &isFree, Grid &r)
{
    nodes.forEach(workers, [&](int x, int y, int low, int end) {
        const std::size_t row = u.index(x, y, 0);
        residualSpan(u.data() + row, f.data() + row, u.strideX(), u.strideY(), low, end,
                     r.data() + row);
        clearHeld(isFree, row, low, end, r.data() + row);
    });
}

/// The weighted mean of a row and the eight around it, by the kernel (1, 2, 1) / 4 along x and y.
void meanOfRows(const float *centre, std::ptrdiff_t sx, std::ptrdiff_t sy, int low, int end,
                float *__restrict mean)
{
    for (int z = low; z < end; ++z)
        mean[z] = 0.25F * centre[z] +
                  0.125F * (centre[z - sx] + centre[z + sx] + centre[z - sy] + centre[z + sy]) +
                  0.0625F * (centre[z - sx - sy] + centre[z - sx + sy] + centre[z + sx - sy] +
                             centre[z + sx + sy]);
}

/// Full weighting, times the squared ratio of the distances of the nodes; at these nodes of the
/// coarse grid.
void restrictTo(Workers &workers, const Grid &fine, const NodeSpans &nodes, Grid &coarse)
{
    nodes.forEach(workers, [&](int x, int y, int low, int end) {
        thread_local std::vector<float> mean;
        mean.resize(static_cast<std::size_t>(fine.cells().z) + 1);
        meanOfRows(fine.data() + fine.index(2 * x, 2 * y, 0), fine.strideX(), fine.strideY(),
                   2 * low - 1, 2 * end, mean.data());
        float *row = coarse.data() + coarse.index(x, y, 0);
        const float *m = mean.data();
        for (std::ptrdiff_t z = low; z < end; ++z)
            row[z] = m[2 * z - 1] + 2 * m[2 * z] + m[2 * z + 1];
    });
}

/// One row of the fine grid along z from those of the coarse grid around it.
void prolongRow(const Grid &coarse, int x, int y, float *__restrict m, float *__restrict fine)
{
    const int columns = coarse.cells().z;
    const float *low = coarse.data() + coarse.index(x / 2, y / 2, 0);
    const std::ptrdiff_t dx = (x & 1) != 0 ? coarse.strideX() : 0;
    const std::ptrdiff_t dy = (y & 1) != 0 ? coarse.strideY() : 0;
    for (int z = 0; z <= columns; ++z)
        m[z] = 0.25F * (low[z] + low[z + dx] + low[z + dy] + low[z + dx + dy]);
    for (std::ptrdiff_t z = 0; z < columns; ++z) {
        fine[2 * z] = m[z];
        fine[2 * z + 1] = 0.5F * (m[z] + m[z + 1]);
    }
}

/// Adds the coarse correction, interpolated, at the nodes that are not held.
void addProlonged(Workers &workers, const Grid &coarse, const Grid &isFree, Grid &fine)
{
    const int last = fine.cells().z;
    forEachPlanes(workers, fine, 1, fine.cells().x - 1, [&](int first, int end) {
        std::vector<float> mean(static_cast<std::size_t>(coarse.cells().z) + 1);
        std::vector<float> added(static_cast<std::size_t>(last) + 1);
        for (int x = first; x < end; ++x)
            for (int y = 1; y < fine.cells().y; ++y) {
                prolongRow(coarse, x, y, mean.data(), added.data());
                const std::size_t row = fine.index(x, y, 0);
                clearHeld(isFree, row, 1, last, added.data());
                const float *a = added.data();
                float *__restrict v = fine.data() + row;
                for (int z = 1; z < last; ++z)
                    v[z] += a[z];
            }
    });
}

/// Calls visit(coarse index) for the nodes of the coarse grid around a node of the fine one, the
/// highest last.
template <class Visit>
void forEachParent(const Grid &coarse, int x, int y, int z, const Visit &visit)
{
    for (int i = x / 2; i <= (x + 1) / 2; ++i)
        for (int j = y / 2; j <= (y + 1) / 2; ++j)
            for (int k = z / 2; k <= (z + 1) / 2; ++k)
                visit(coarse.index(i, j, k));
}

/// A coarse node is held where its fine node is. Held fine nodes around which no coarse node is,
/// such as those of a thin wall between two of its planes, hold one too: a coarse grid that does
/// not feel a wall corrects across it, by more than the error, and the cycles diverge.
void holdCoarser(const Grid &fine, Grid &coarse)
{
    const auto forEachNode = [](const Grid &grid, const auto &visit) {
        for (int x = 0; x <= grid.cells().x; ++x)
            for (int y = 0; y <= grid.cells().y; ++y)
                for (int z = 0; z <= grid.cells().z; ++z)
                    visit(x, y, z);
    };
    forEachNode(coarse,
                [&](int x, int y, int z) { coarse.at(x, y, z) = fine.at(2 * x, 2 * y, 2 * z); });
    forEachNode(fine, [&](int x, int y, int z) {
        // Most held nodes are among others.
        if (fine.at(x, y, z) != 0 || coarse.at(x / 2, y / 2, z / 2) == 0)
            return;
        bool isFelt = false;
        std::size_t highest = 0;
        forEachParent(coarse, x, y, z, [&](std::size_t parent) {
            isFelt = isFelt || coarse[parent] == 0;
            highest = parent;
        });
        if (!isFelt)
            coarse[highest] = 0;
    });
}

} // namespace

PoissonMultigrid::PoissonMultigrid(const GridSize &cells, Workers &workers) : workers_(&workers)
{
    GridSize size = cells;
    const auto canHalve = [](int n) { return n % 2 == 0 && n > coarsestCells; };
    while (true) {
        levels_.emplace_back(size);
        if (levels_.size() > 1) {
            levels_.back().correction = Grid(size);
            levels_.back().source = Grid(size);
        }
        if (!canHalve(size.x) || !canHalve(size.y) || !canHalve(size.z))
            break;
        size = size.halved();
    }
}

PoissonMultigrid::Level::Level(const GridSize &size)
    : cells(size), scratch(size), relaxed(size), around(size), reached(size)
{
}

void PoissonMultigrid::workAround(const NodeSpans &sources)
{
    NodeSpans reached = sources;
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
        Level &here = levels_[level];
        Level &below = levels_[level + 1];
        if (here.cells.resolution() < sparseCells)
            return;
        here.relaxed = std::move(reached);
        here.around = here.relaxed.widened();
        here.scratch.fill(0);
        reached = here.around.halved();
        below.reached = reached;
        below.source.fill(0);
    }
}

void PoissonMultigrid::hold(const std::vector<unsigned char> &isHeld)
{
    for (Level &level : levels_)
        level.isFree = Grid(level.cells);
    Grid &finest = levels_.front().isFree;
    for (std::size_t i = 0; i < isHeld.size(); ++i)
        finest[i] = isHeld[i] != 0 ? 0 : 1;
    for (std::size_t level = 1; level < levels_.size(); ++level)
        holdCoarser(levels_[level - 1].isFree, levels_[level].isFree);
}

void PoissonMultigrid::solve(Grid &u, const Grid &f, int cycles) const
{
    for (int i = 0; i < cycles; ++i)
        cycle(u, f, 0);
}

void PoissonMultigrid::cycle(Grid &u, const Grid &f, std::size_t level) const
{
    const Grid &isFree = levels_[level].isFree;
    if (level + 1 == levels_.size())
        return sweep(u, f, isFree, coarsestSweeps);
    Level &here = levels_[level];
    Level &below = levels_[level + 1];
    // The second step reads what the first has written one node further.
    relax(*workers_, here.around, u, f, isFree, firstWeight, here.scratch);
    relax(*workers_, here.relaxed, here.scratch, f, isFree, secondWeight, u);
    computeResidual(*workers_, here.around, u, f, isFree, here.scratch);
    restrictTo(*workers_, here.scratch, below.reached, below.source);
    below.correction.fill(0);
    cycle(below.correction, below.source, level + 1);
    addProlonged(*workers_, below.correction, isFree, u);
    relax(*workers_, here.around, u, f, isFree, secondWeight, here.scratch);
    relax(*workers_, here.relaxed, here.scratch, f, isFree, firstWeight, u);
}

} // namespace neuralmesh
