// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/parallel/watch.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Sampler::draw() of any number of samples, in parts between which the watch is looked at.
void drawWatched(const Sampler &sampler, Random &random, std::size_t count,
                 std::vector<Point> &samples, const Watch &watch);

} // namespace neuralmesh
