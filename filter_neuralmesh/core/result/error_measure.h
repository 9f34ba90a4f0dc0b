// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result/sample_distances.h"

namespace neuralmesh {

/// Distances of samples of the target space from the mesh, in the unit frame.
struct ErrorFigures {
    double rms = 0;
    double largest = 0;
};

ErrorFigures errorOf(const SampleDistances &distances);

} // namespace neuralmesh
