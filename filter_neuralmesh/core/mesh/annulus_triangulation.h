// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of least weight of the band between two closed loops of edges in space.
//
// Fuchs, Kedem, Uselton: Optimal surface reconstruction from planar contours (CACM 1977).
#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace neuralmesh {

struct AnnulusTriangulation {
    /// The edges from loop to loop, in order round the band: place in the first, place in the
    /// second. From each to the next, the first goes one forward or the second one back.
    std::vector<std::pair<int, int>> rungs;
    double weight = std::numeric_limits<double>::infinity(); ///< the sum over the triangles
};

/// Weight of the triangle between rung (i, j) and the next: that of places i, i + 1 of the first
/// loop and j of the second, or that of i, and j, j - 1 of the second. Infinite forbids it.
struct AnnulusWeights {
    std::function<double(int i, int j)> forwardOnFirst;
    std::function<double(int i, int j)> backOnSecond;
};

/// For loops of `first` and `second` >= 3 corners that run in opposite directions round the band.
/// No rungs where everything is forbidden or the least weight takes one edge twice. Time grows with
/// first · second².
AnnulusTriangulation triangulateAnnulus(int first, int second, const AnnulusWeights &weights);

} // namespace neuralmesh
