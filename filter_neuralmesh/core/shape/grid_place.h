// SPDX-License-Identifier: GPL-3.0-or-later
// A place between the nodes of a grid: trilinear interpolation, its gradient, and their adjoints.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/shape/grid.h"

namespace neuralmesh {

/// The lowest node of the cell around the place, and how far beyond it the place lies, in cells.
struct GridPlace {
    std::uint32_t node;
    float x, y, z;
};

/// `place` within the grid's box.
inline GridPlace placeInGrid(const Grid &grid, const Point3 &place)
{
    const GridSize &cells = grid.cells();
    const int count[3] = {cells.x, cells.y, cells.z};
    int cell[3];
    float beyond[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double scaled = place[axis] * grid.resolution();
        cell[axis] = std::clamp(static_cast<int>(scaled), 0, count[axis] - 1);
        beyond[axis] = static_cast<float>(scaled - cell[axis]);
    }
    return {static_cast<std::uint32_t>(grid.index(cell[0], cell[1], cell[2])), beyond[0], beyond[1],
            beyond[2]};
}

/// Calls visit(offset, weight) for the four corners of a cell's side, in the order of the strides.
template <class Visit>
void forEachSideCorner(std::ptrdiff_t strideA, float a, std::ptrdiff_t strideB, float b,
                       const Visit &visit)
{
    visit(std::ptrdiff_t(0), (1 - a) * (1 - b));
    visit(strideB, (1 - a) * b);
    visit(strideA, a * (1 - b));
    visit(strideA + strideB, a * b);
}

inline float interpolate(const Grid &grid, const GridPlace &p)
{
    const float *v = grid.data() + p.node;
    float sum = 0;
    forEachSideCorner(grid.strideX(), p.x, grid.strideY(), p.y,
                      [&](std::ptrdiff_t i, float weight) {
                          sum += weight * ((1 - p.z) * v[i] + p.z * v[i + 1]);
                      });
    return sum;
}

/// The adjoint of interpolate(): adds the value to the nodes around the place.
inline void splat(Grid &grid, const GridPlace &p, float value)
{
    float *v = grid.data() + p.node;
    forEachSideCorner(grid.strideX(), p.x, grid.strideY(), p.y,
                      [&](std::ptrdiff_t i, float weight) {
                          v[i] += weight * (1 - p.z) * value;
                          v[i + 1] += weight * p.z * value;
                      });
}

/// Of the central differences of the nodes, interpolated; a cell is the unit of length. The place
/// must lie a cell or more from the border.
inline vcg::Point3f gradientAt(const Grid &grid, const GridPlace &p)
{
    const std::ptrdiff_t sx = grid.strideX();
    const std::ptrdiff_t sy = grid.strideY();
    const auto along = [&](std::ptrdiff_t stride, float beyond, std::ptrdiff_t strideA, float a,
                           std::ptrdiff_t strideB, float b) {
        const float *v = grid.data() + p.node;
        float sum = 0;
        forEachSideCorner(strideA, a, strideB, b, [&](std::ptrdiff_t i, float weight) {
            sum += weight * ((1 - beyond) * (v[i + stride] - v[i - stride]) +
                             beyond * (v[i + 2 * stride] - v[i]));
        });
        return sum / 2;
    };
    return {along(sx, p.x, sy, p.y, 1, p.z), along(sy, p.y, sx, p.x, 1, p.z),
            along(1, p.z, sx, p.x, sy, p.y)};
}

/// How far the place lies beyond the level 0, on the side where the grid is positive, in cells: by
/// the value there and its slope (Taubin 1991). It must lie a cell or more from the border.
inline double cellsBeyondLevel(const Grid &grid, const GridPlace &p)
{
    return static_cast<double>(interpolate(grid, p)) /
           static_cast<double>(gradientAt(grid, p).Norm());
}

/// splatDivergence() reaches so many nodes beyond the corners of the place's cell.
constexpr int reachOfDivergence = 1;

/// The adjoint of -gradientAt(): adds the divergence of the vector, spread to the nodes around.
inline void splatDivergence(Grid &grid, const GridPlace &p, const vcg::Point3f &vector)
{
    const std::ptrdiff_t sx = grid.strideX();
    const std::ptrdiff_t sy = grid.strideY();
    const auto along = [&](float component, std::ptrdiff_t stride, float beyond,
                           std::ptrdiff_t strideA, float a, std::ptrdiff_t strideB, float b) {
        float *v = grid.data() + p.node;
        forEachSideCorner(strideA, a, strideB, b, [&](std::ptrdiff_t i, float weight) {
            const float low = weight * (1 - beyond) * component / 2;
            const float high = weight * beyond * component / 2;
            v[i - stride] += low;
            v[i] += high;
            v[i + stride] -= low;
            v[i + 2 * stride] -= high;
        });
    };
    along(vector.X(), sx, p.x, sy, p.y, 1, p.z);
    along(vector.Y(), sy, p.y, sx, p.x, 1, p.z);
    along(vector.Z(), 1, p.z, sx, p.x, sy, p.y);
}

} // namespace neuralmesh
