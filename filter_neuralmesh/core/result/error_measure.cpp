// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/error_measure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/space/morton_order.h"

namespace neuralmesh {

ErrorFigures measureError(const GrowingNetwork &network, const Sampler &sampler, Random &random,
                          std::size_t samplesPerVertex)
{
    std::vector<Point> drawn;
    sampler.draw(random, samplesPerVertex * static_cast<std::size_t>(network.vertexCount()), drawn);
    std::vector<Point3> samples;
    MortonOrder(sampler.bounds()).sort(drawn, samples);
    double sum = 0;
    double largest = 0;
    VertexId nearest = noVertex;
    for (const Point3 &sample : samples) {
        nearest = network.nearestVertex(sample, nearest);
        const double squared = network.projectExactly(nearest, sample).squaredDistance;
        sum += squared;
        largest = std::max(largest, squared);
    }
    return {std::sqrt(sum / static_cast<double>(samples.size())), std::sqrt(largest)};
}

} // namespace neuralmesh
