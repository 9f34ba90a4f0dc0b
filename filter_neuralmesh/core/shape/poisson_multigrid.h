// SPDX-License-Identifier: GPL-3.0-or-later
// Poisson's equation on a grid, by multigrid.
#pragma once

#include <vector>

#include "core/shape/grid.h"

namespace neuralmesh {

/// Solves the seven-point discretisation of -Δu = f, with the nodes' distance as the unit of
/// length and u = 0 at the border of the grid and at nodes that are held. V-cycles of red-black
/// Gauss-Seidel (Brandt 1977), linear in the number of nodes.
class PoissonMultigrid {
public:
    /// `cells` must be a power of two.
    explicit PoissonMultigrid(int cells);

    /// Holds u at 0 where `isHeld` is not 0, beside the border. By node, as in Grid.
    void hold(const std::vector<unsigned char> &isHeld);

    /// Improves `u` by V-cycles. Each leaves about a tenth of the error.
    void solve(Grid &u, const Grid &f, int cycles) const;

private:
    struct Level {
        Grid correction;
        Grid source;
        Grid residual;
        std::vector<unsigned char> isHeld; ///< empty where none is
    };

    void cycle(Grid &u, const Grid &f, std::size_t level) const;

    mutable std::vector<Level> levels_; ///< finest first; scratch of solve() but for isHeld
};

} // namespace neuralmesh
