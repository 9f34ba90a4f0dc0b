// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/sample_distances.h"

#include "core/space/morton_order.h"
#include "core/space/watched_draw.h"

namespace neuralmesh {

SampleDistances measureDistances(const GrowingNetwork &network, const Sampler &sampler,
                                 Random &random, std::size_t samples)
{
    std::vector<Point> drawn;
    drawWatched(sampler, random, samples, drawn, network.workers().watch());
    SampleDistances distances;
    MortonOrder(sampler.bounds()).sort(drawn, distances.samples);
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
