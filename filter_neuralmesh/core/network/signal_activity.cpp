// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/signal_activity.h"

#include <algorithm>
#include <cmath>

namespace neuralmesh {
namespace {

/// Share of a signal's count that depends on the distance, and the most that a distance may count,
/// in means.
constexpr double errorShare = 0.75;
constexpr double mostRelative = 4;
/// Weight of a new sample in the running mean.
constexpr double meanWeight = 0.001;

} // namespace

double SignalActivity::ofRelative(double relative)
{
    return 1 - errorShare + errorShare * std::min(relative, mostRelative);
}

double SignalActivity::count(Scalar distance)
{
    const double roughness = std::sqrt(distance);
    meanRoughness_ += (roughness - meanRoughness_) * (hasMean_ ? meanWeight : 1);
    hasMean_ = true;
    // While all samples lay on the surface, the distance says nothing.
    return ofRelative(meanRoughness_ > 0 ? roughness / meanRoughness_ : 1);
}

} // namespace neuralmesh
