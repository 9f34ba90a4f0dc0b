// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/sample_distances.h"

#include "core/space/morton_order.h"

namespace neuralmesh {

SampleDistances measureDistances(const GrowingNetwork &network, const Sampler &sampler,
                                 Random &random, std::size_t samplesPerVertex)
{
    std::vector<Point> drawn;
    sampler.draw(random, samplesPerVertex * static_cast<std::size_t>(network.vertexCount()), drawn);
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
