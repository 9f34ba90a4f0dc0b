// SPDX-License-Identifier: GPL-3.0-or-later
// Poisson's equation on a grid, by multigrid.
#pragma once

#include <vector>

#include "core/parallel/workers.h"
#include "core/shape/grid.h"
#include "core/shape/node_spans.h"

namespace neuralmesh {

/// Solves the seven-point discretisation of -Δu = f, with the nodes' distance as the unit of
/// length and u = 0 at the border of the grid and at nodes that are held. V-cycles (Brandt 1977)
/// whose smoother is two steps of Jacobi's method with Chebyshev's weights, since all nodes of a
/// step are independent. Linear in the number of nodes.
class PoissonMultigrid {
public:
    /// Coarser grids follow as long as the cells along each axis can be halved.
    PoissonMultigrid(const GridSize &cells, Workers &workers);

    /// Holds u at 0 where `isHeld` is not 0, beside the border. By node, as in Grid.
    void hold(const std::vector<unsigned char> &isHeld);

    /// For sources f that are 0 but at these nodes: the fine grids of the multigrid are worked on
    /// around them alone. Elsewhere u is smooth, and changes only by what the coarser grid
    /// corrects, interpolated.
    void workAround(const NodeSpans &sources);

    /// Improves `u`, which must be 0 where it is held, by V-cycles. Each leaves a fifth of the
    /// error; up to two thirds around held walls, lines and nodes that no coarser grid has nodes
    /// on.
    void solve(Grid &u, const Grid &f, int cycles) const;

private:
    struct Level {
        explicit Level(const GridSize &size);

        GridSize cells;
        Grid correction, source; ///< empty on the finest level
        Grid scratch;            ///< 0 but at the nodes `around`
        Grid isFree;             ///< 0 where a node is held, else 1; empty where none is
        NodeSpans relaxed;
        NodeSpans around;  ///< and the nodes beside them: what relaxing reads
        NodeSpans reached; ///< by the residuals of the finer level: the source is 0 elsewhere
    };

    void cycle(Grid &u, const Grid &f, std::size_t level) const;

    Workers *workers_;
    mutable std::vector<Level> levels_; ///< finest first; scratch of solve() but for isFree
};

} // namespace neuralmesh
