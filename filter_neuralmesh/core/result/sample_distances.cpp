// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/sample_distances.h"

#include "core/space/ordered_samples.h"

namespace neuralmesh {

SampleDistances measureDistances(const GrowingNetwork &network, const Sampler &sampler,
                                 Random &random, std::size_t samples)
{
    OrderedSamples ordered(sampler, network.workers().watch());
    SampleDistances distances;
    distances.samples = ordered.draw(random, samples);
    distances.squared.resize(distances.samples.size());
    const SampleLocator locator = network.locator();
    locator.forEachNearest(
        network.workers(), distances.samples, [&](std::size_t i, VertexId nearest) {
            distances.squared[i] =
                locator.projectExactly(nearest, distances.samples[i]).squaredDistance;
        });
    return distances;
}

} // namespace neuralmesh
