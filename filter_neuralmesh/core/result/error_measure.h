// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/network/growing_network.h"
#include "neuralmesh/random.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Distances of samples of the target space from the mesh, in the unit frame.
struct ErrorFigures {
    double rms = 0;
    double largest = 0;
};

/// Draws `samplesPerVertex` samples for each vertex and takes their distances from the nearest
/// face, found as in the fit, and where that may miss it, around the nearest vertex's neighbours.
ErrorFigures measureError(const GrowingNetwork &network, const Sampler &sampler, Random &random,
                          std::size_t samplesPerVertex);

} // namespace neuralmesh
