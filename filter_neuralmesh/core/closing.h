// SPDX-License-Identifier: GPL-3.0-or-later
// The way from an open network to a closed result of the exact count of vertices.
#pragma once

#include <algorithm>

#include "core/network/growing_network.h"
#include "core/topology/sheet_doubling.h"

namespace neuralmesh {

/// Counts the vertices that the result will have, and closes the network in the end: sheets by
/// sheets behind them, other boundaries by discs, which need no vertices.
class Closing {
public:
    /// Of a network that is not to be closed, or without sheets, the result has the same vertices.
    Closing(GrowingNetwork &network, int target)
        : network_(network), target_(target), sheets_(network.mesh())
    {
    }

    /// From now on, the sheets among the components count as if they were doubled.
    void judgeSheets() { sheetsDoubled_ = sheets_.judge(); }

    int vertexCount() const { return network_.vertexCount() + sheets_.copies(); }
    /// By how many vertices a split may go beyond a count.
    int mostOver() const { return sheets_.isEmpty() ? 0 : 1; }
    /// Vertices that the result still lacks; below 0, that it has too many.
    int room() const { return target_ - vertexCount(); }

    /// Splits the most active vertex, or a boundary where there is room for one vertex only.
    /// Returns how many vertices the result gains, one or two.
    int addVertex(int room);

    /// Brings the network to the count of the result, which changes where boundaries do: with holes
    /// and notches that are filled.
    void settleCount();

    /// The result has no more vertices than now: there is no time.
    void endHere() { target_ = std::min(target_, vertexCount()); }

    /// Closes all boundaries. Returns how many faces intersect another then.
    int close();

    int sheetsDoubled() const { return sheetsDoubled_; }
    /// Boundaries that close() filled by discs.
    int holesFilled() const { return holesFilled_; }

private:
    GrowingNetwork &network_;
    int target_;
    OpenSheets sheets_;
    int sheetsDoubled_ = 0;
    int holesFilled_ = 0;
};

} // namespace neuralmesh
