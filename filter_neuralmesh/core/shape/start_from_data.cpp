// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/start_from_data.h"

#include <algorithm>
#include <vector>

#include "core/random_streams.h"
#include "core/shape/coarse_shape.h"
#include "core/space/plain_points.h"

namespace neuralmesh {
namespace {

/// Vertices of the start: the shape of most things, and still coarse.
constexpr int mostVertices = 500;

/// Samples that it is made of; of fewer points, so many for each, which leaves out one in fifty.
constexpr std::size_t mostSamples = 64000;
constexpr std::size_t samplesPerPoint = 4;

} // namespace

CoarseShape startFromData(NeuralMesh &mesh, const Sampler &sampler,
                          const GrowthParameters &parameters, const Progress &progress)
{
    Random random = randomStream(parameters.seed, Purpose::shape);
    const std::size_t points = std::min(mostSamples, sampler.pointCount());
    std::vector<Point> samples;
    sampler.draw(random, std::min(mostSamples, samplesPerPoint * points), samples);
    const int vertices = std::min(mostVertices, parameters.targetVertexCount / 2);
    CoarseShape shape = findCoarseShape(mesh, toVcg(samples), sampler.pointCount(), vertices,
                                        parameters.maxHoleSize, progress);
    shape.isTrusted = shape.isTrusted && mesh.vn <= parameters.targetVertexCount;
    return shape;
}

} // namespace neuralmesh
