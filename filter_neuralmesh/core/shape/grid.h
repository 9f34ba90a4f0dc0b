// SPDX-License-Identifier: GPL-3.0-or-later
// A function on the nodes of a regular grid.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Cells along each axis.
struct GridSize {
    int x = 0, y = 0, z = 0;

    /// Cells to the unit of length: the longest side is 1 long.
    int resolution() const { return std::max({x, y, z}); }
    GridSize doubled() const { return {2 * x, 2 * y, 2 * z}; }
    bool canHalve() const { return x % 2 == 0 && y % 2 == 0 && z % 2 == 0; }
    GridSize halved() const { return {x / 2, y / 2, z / 2}; }
};

/// Values at (x + 1) (y + 1) (z + 1) nodes of cubic cells; node (x, y, z) lies at (x, y, z) /
/// resolution. Single precision, since the grid only has to tell inside from outside.
class Grid {
public:
    Grid() = default;
    explicit Grid(const GridSize &cells, float value = 0)
        : cells_(cells),
          values_(static_cast<std::size_t>(cells.x + 1) * static_cast<std::size_t>(cells.y + 1) *
                      static_cast<std::size_t>(cells.z + 1),
                  value)
    {
    }

    const GridSize &cells() const { return cells_; }
    int resolution() const { return cells_.resolution(); }
    std::size_t size() const { return values_.size(); }
    bool isEmpty() const { return values_.empty(); }

    /// Steps between the values of neighbouring nodes; 1 along z.
    std::ptrdiff_t strideX() const { return strideY() * (cells_.y + 1); }
    std::ptrdiff_t strideY() const { return cells_.z + 1; }

    std::size_t index(int x, int y, int z) const
    {
        return static_cast<std::size_t>(x * strideX() + y * strideY() + z);
    }
    float operator[](std::size_t i) const { return values_[i]; }
    float &operator[](std::size_t i) { return values_[i]; }
    float at(int x, int y, int z) const { return values_[index(x, y, z)]; }
    float &at(int x, int y, int z) { return values_[index(x, y, z)]; }
    const float *data() const { return values_.data(); }
    float *data() { return values_.data(); }
    void fill(float value) { values_.assign(values_.size(), value); }

private:
    GridSize cells_;
    std::vector<float> values_;
};

/// Calls visit(row) for each row of inner nodes: the index of its node at z = 0, which is not inner
/// itself. Inner are z = 1 ... cells().z - 1.
template <class Visit> void forEachInnerRow(const Grid &grid, const Visit &visit)
{
    for (int x = 1; x < grid.cells().x; ++x)
        for (int y = 1; y < grid.cells().y; ++y)
            visit(grid.index(x, y, 0));
}

} // namespace neuralmesh
