// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/error_measure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/network/star_projection.h"
#include "core/space/morton_order.h"

namespace neuralmesh {
namespace {

/// Looks at the stars of the winner and of its neighbours: the nearest vertex need not be a corner
/// of the nearest face.
double squaredDistance(const NeuralMesh &mesh, VertexId winner, const Point3 &sample)
{
    double least = projectOnStar(mesh, winner, sample).squaredDistance;
    for (const VertexId v : mesh.ring(winner))
        least = std::min(least, projectOnStar(mesh, v, sample).squaredDistance);
    return least;
}

} // namespace

ErrorFigures measureError(const GrowingNetwork &network, const Sampler &sampler, Random &random,
                          std::size_t samplesPerVertex)
{
    std::vector<Point3> samples;
    sampler.draw(random, samplesPerVertex * static_cast<std::size_t>(network.vertexCount()),
                 samples);
    MortonOrder(sampler.bounds()).sort(samples);
    double sum = 0;
    double largest = 0;
    VertexId nearest = noVertex;
    for (const Point3 &sample : samples) {
        nearest = network.nearestVertex(sample, nearest);
        const double squared = squaredDistance(network.mesh(), nearest, sample);
        sum += squared;
        largest = std::max(largest, squared);
    }
    return {std::sqrt(sum / static_cast<double>(samples.size())), std::sqrt(largest)};
}

} // namespace neuralmesh
