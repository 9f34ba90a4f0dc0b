// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/poisson_multigrid.h"

#include <algorithm>

namespace neuralmesh {
namespace {

constexpr int coarsestCells = 4;
constexpr int coarsestSweeps = 16;
constexpr int sweepsBefore = 1;
constexpr int sweepsAfter = 1;

using Held = std::vector<unsigned char>;

/// One half of a red-black sweep: the inner nodes whose coordinates' sum has this parity.
void relax(Grid &u, const Grid &f, const Held &isHeld, int parity)
{
    const int last = u.cells();
    const std::ptrdiff_t sx = u.strideX();
    const std::ptrdiff_t sy = u.strideY();
    for (int x = 1; x < last; ++x)
        for (int y = 1; y < last; ++y) {
            const std::size_t row = u.index(x, y, 0);
            float *v = u.data() + row;
            const float *s = f.data() + row;
            const unsigned char *held = isHeld.empty() ? nullptr : isHeld.data() + row;
            for (int z = 1 + ((x + y + 1 + parity) & 1); z < last; z += 2) {
                const float mean =
                    (v[z - sx] + v[z + sx] + v[z - sy] + v[z + sy] + v[z - 1] + v[z + 1] + s[z]) *
                    (1.0F / 6);
                v[z] = held != nullptr && held[z] != 0 ? 0 : mean;
            }
        }
}

void sweep(Grid &u, const Grid &f, const Held &isHeld, int times)
{
    for (int i = 0; i < times; ++i) {
        relax(u, f, isHeld, 0);
        relax(u, f, isHeld, 1);
    }
}

void computeResidual(const Grid &u, const Grid &f, const Held &isHeld, Grid &r)
{
    const int last = u.cells();
    const std::ptrdiff_t sx = u.strideX();
    const std::ptrdiff_t sy = u.strideY();
    for (int x = 1; x < last; ++x)
        for (int y = 1; y < last; ++y) {
            const std::size_t row = u.index(x, y, 0);
            const float *v = u.data() + row;
            const float *s = f.data() + row;
            float *d = r.data() + row;
            for (int z = 1; z < last; ++z)
                d[z] = s[z] - 6 * v[z] + v[z - sx] + v[z + sx] + v[z - sy] + v[z + sy] + v[z - 1] +
                       v[z + 1];
            if (!isHeld.empty())
                for (int z = 1; z < last; ++z)
                    d[z] = isHeld[row + static_cast<std::size_t>(z)] != 0 ? 0 : d[z];
        }
}

/// Full weighting, times the squared ratio of the distances of the nodes.
void restrictTo(const Grid &fine, Grid &coarse)
{
    const std::ptrdiff_t sx = fine.strideX();
    const std::ptrdiff_t sy = fine.strideY();
    const int last = coarse.cells();
    constexpr float weights[3] = {0.25F, 0.5F, 0.25F};
    for (int x = 1; x < last; ++x)
        for (int y = 1; y < last; ++y)
            for (int z = 1; z < last; ++z) {
                const float *centre = fine.data() + fine.index(2 * x, 2 * y, 2 * z);
                float sum = 0;
                for (int i = -1; i <= 1; ++i)
                    for (int j = -1; j <= 1; ++j) {
                        const float *row = centre + i * sx + j * sy;
                        sum += weights[i + 1] * weights[j + 1] *
                               (0.25F * (row[-1] + row[1]) + 0.5F * row[0]);
                    }
                coarse.at(x, y, z) = 4 * sum;
            }
}

/// Adds the coarse correction, interpolated, at the nodes that are not held.
void addProlonged(const Grid &coarse, const Held &isHeld, Grid &fine)
{
    const int last = fine.cells();
    const std::ptrdiff_t sx = coarse.strideX();
    const std::ptrdiff_t sy = coarse.strideY();
    for (int x = 1; x < last; ++x)
        for (int y = 1; y < last; ++y) {
            const float *low = coarse.data() + coarse.index(x / 2, y / 2, 0);
            const std::ptrdiff_t dx = (x & 1) != 0 ? sx : 0;
            const std::ptrdiff_t dy = (y & 1) != 0 ? sy : 0;
            const std::size_t row = fine.index(x, y, 0);
            const auto mean = [&](int z) {
                return 0.25F * (low[z] + low[z + dx] + low[z + dy] + low[z + dx + dy]);
            };
            float before = mean(0);
            for (int z = 1; z < last; z += 2) {
                const float after = mean(z / 2 + 1);
                const std::size_t odd = row + static_cast<std::size_t>(z);
                if (isHeld.empty() || isHeld[odd] == 0)
                    fine[odd] += 0.5F * (before + after);
                if (z + 1 < last && (isHeld.empty() || isHeld[odd + 1] == 0))
                    fine[odd + 1] += after;
                before = after;
            }
        }
}

} // namespace

PoissonMultigrid::PoissonMultigrid(int cells)
{
    for (int n = cells; n >= coarsestCells; n /= 2)
        levels_.push_back({Grid(n), Grid(n), Grid(n), {}});
}

void PoissonMultigrid::hold(const std::vector<unsigned char> &isHeld)
{
    levels_.front().isHeld = isHeld;
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        const Grid &fine = levels_[level - 1].residual;
        const Held &above = levels_[level - 1].isHeld;
        Level &below = levels_[level];
        below.isHeld.assign(below.residual.size(), 0);
        for (int x = 0; x <= below.residual.cells(); ++x)
            for (int y = 0; y <= below.residual.cells(); ++y)
                for (int z = 0; z <= below.residual.cells(); ++z)
                    below.isHeld[below.residual.index(x, y, z)] =
                        above[fine.index(2 * x, 2 * y, 2 * z)];
    }
}

void PoissonMultigrid::solve(Grid &u, const Grid &f, int cycles) const
{
    for (int i = 0; i < cycles; ++i)
        cycle(u, f, 0);
}

void PoissonMultigrid::cycle(Grid &u, const Grid &f, std::size_t level) const
{
    const Held &isHeld = levels_[level].isHeld;
    if (level + 1 == levels_.size())
        return sweep(u, f, isHeld, coarsestSweeps);
    sweep(u, f, isHeld, sweepsBefore);
    computeResidual(u, f, isHeld, levels_[level].residual);
    Level &below = levels_[level + 1];
    restrictTo(levels_[level].residual, below.source);
    below.correction.fill(0);
    cycle(below.correction, below.source, level + 1);
    addProlonged(below.correction, isHeld, u);
    sweep(u, f, isHeld, sweepsAfter);
}

} // namespace neuralmesh
