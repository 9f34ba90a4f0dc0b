// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/measurement.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Samples for each vertex, and the most of them where time is up.
constexpr std::size_t samplesPerVertex = 6;
constexpr std::size_t mostInHaste = 20000;

/// Fewer samples than usual tell no more than a target space of so few points.
Measurement measureBy(std::size_t samples, std::size_t points, const GrowingNetwork &network,
                      const Sampler &sampler, Random &random)
{
    const SampleDistances distances = measureDistances(network, sampler, random, samples);
    return {errorOf(distances), supportOf(network, distances, points)};
}

} // namespace

Measurement measure(const GrowingNetwork &network, const Sampler &sampler, Random &random,
                    bool isTimeUp)
{
    const std::size_t usual = samplesPerVertex * static_cast<std::size_t>(network.vertexCount());
    if (!isTimeUp)
        try {
            return measureBy(usual, sampler.pointCount(), network, sampler, random);
        } catch (const TimeIsUp &) {
            network.workers().watch().mindTime(false);
        }
    const std::size_t few = std::min(usual, mostInHaste);
    return measureBy(few, std::min(few, sampler.pointCount()), network, sampler, random);
}

} // namespace neuralmesh
