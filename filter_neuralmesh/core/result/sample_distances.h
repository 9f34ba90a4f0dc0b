// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/network/growing_network.h"
#include "neuralmesh/random.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Fresh samples of the target space, in Morton order, with their distances from the mesh.
struct SampleDistances {
    std::vector<Point3> samples;
    std::vector<Scalar> squared; ///< distance of each from the nearest face, squared
};

/// Of so many samples. The nearest face is found as in the fit, and
/// where that may miss it, around the nearest vertex's neighbours.
SampleDistances measureDistances(const GrowingNetwork &network, const Sampler &sampler,
                                 Random &random, std::size_t samples);

} // namespace neuralmesh
