// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the mesh is where the points are, and nowhere else.
#pragma once

#include "core/result/sample_distances.h"

namespace neuralmesh {

/// Near and far are told apart by the mean length of the mesh's edges; where the points are so
/// sparse that their spacing is greater, by as much more. No face is far that is within twice the
/// spacing of the samples around the one nearest to it: density may vary.
struct SupportFigures {
    double coverage = 0;        ///< share of the samples that are near the mesh
    double unsupportedArea = 0; ///< share of the mesh's area that is far from all samples
};

/// Of a target space of so many points, of which these are samples.
SupportFigures supportOf(const GrowingNetwork &network, const SampleDistances &distances,
                         std::size_t points);

} // namespace neuralmesh
