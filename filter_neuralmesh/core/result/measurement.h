// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result/error_measure.h"
#include "core/result/support_measure.h"

namespace neuralmesh {

/// How near the mesh is to the target space, by fresh samples of it.
struct Measurement {
    ErrorFigures error;
    SupportFigures support;
};

/// Where time is up, or comes up meanwhile, few samples have to do, and the watch of the network's
/// workers minds it no longer.
Measurement measure(const GrowingNetwork &network, const Sampler &sampler, Random &random,
                    bool isTimeUp);

} // namespace neuralmesh
