// SPDX-License-Identifier: GPL-3.0-or-later
// A function on the nodes of a regular grid over the unit cube.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Values at (cells + 1)³ nodes; node (x, y, z) lies at (x, y, z) / cells. Single precision, since
/// the grid only has to tell inside from outside.
class Grid {
public:
    Grid() = default;
    explicit Grid(int cells, float value = 0)
        : cells_(cells), nodes_(cells + 1),
          values_(static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(nodes_) *
                      static_cast<std::size_t>(nodes_),
                  value)
    {
    }

    int cells() const { return cells_; }
    int nodesPerAxis() const { return nodes_; }
    std::size_t size() const { return values_.size(); }

    /// Steps between the values of neighbouring nodes.
    std::ptrdiff_t strideX() const { return static_cast<std::ptrdiff_t>(nodes_) * nodes_; }
    std::ptrdiff_t strideY() const { return nodes_; }

    std::size_t index(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(x) * static_cast<std::size_t>(nodes_) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(nodes_) +
               static_cast<std::size_t>(z);
    }
    float operator[](std::size_t i) const { return values_[i]; }
    float &operator[](std::size_t i) { return values_[i]; }
    float at(int x, int y, int z) const { return values_[index(x, y, z)]; }
    float &at(int x, int y, int z) { return values_[index(x, y, z)]; }
    const float *data() const { return values_.data(); }
    float *data() { return values_.data(); }
    void fill(float value) { values_.assign(values_.size(), value); }

private:
    int cells_ = 0;
    int nodes_ = 0;
    std::vector<float> values_;
};

/// The eight nodes around a place, and their weights in trilinear interpolation.
struct TrilinearWeights {
    std::array<std::uint32_t, 8> nodes;
    std::array<float, 8> weights;
};

/// `place` in the unit cube.
inline TrilinearWeights trilinearWeights(const Grid &grid, const Point3 &place)
{
    int cell[3];
    float fraction[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double scaled = place[axis] * grid.cells();
        const int low = static_cast<int>(scaled);
        cell[axis] = low < 0 ? 0 : low >= grid.cells() ? grid.cells() - 1 : low;
        fraction[axis] = static_cast<float>(scaled - cell[axis]);
    }
    TrilinearWeights w{};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const int x = corner & 1U, y = (corner >> 1U) & 1U, z = (corner >> 2U) & 1U;
        w.nodes[corner] =
            static_cast<std::uint32_t>(grid.index(cell[0] + x, cell[1] + y, cell[2] + z));
        w.weights[corner] = (x != 0 ? fraction[0] : 1 - fraction[0]) *
                            (y != 0 ? fraction[1] : 1 - fraction[1]) *
                            (z != 0 ? fraction[2] : 1 - fraction[2]);
    }
    return w;
}

inline float interpolate(const Grid &grid, const TrilinearWeights &w)
{
    float sum = 0;
    for (std::size_t i = 0; i < 8; ++i)
        sum += w.weights[i] * grid[w.nodes[i]];
    return sum;
}

} // namespace neuralmesh
