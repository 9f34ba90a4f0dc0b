// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/start_from_data.h"

#include <algorithm>
#include <vector>

#include "core/random_streams.h"
#include "core/shape/coarse_shape.h"
#include "core/shape/even_density.h"
#include "core/space/plain_points.h"

namespace neuralmesh {
namespace {

/// Vertices of the start, as a share of the target's. A start that is much coarser than walls are
/// thick does not part them, and growth does not do so later.
constexpr double shareOfTarget = 0.5;

/// Samples that it is made of; of fewer points, so many for each, which leave out one in fifty
/// where they are independent. Those of strata leave out none; repeated ones follow each other, and
/// go.
constexpr std::size_t mostSamples = 128000;
constexpr std::size_t samplesPerPoint = 4;

} // namespace

CoarseShape startFromData(NeuralMesh &mesh, const Sampler &sampler,
                          const GrowthParameters &parameters, Workers &workers,
                          const Progress &progress)
{
    Random random = randomStream(parameters.seed, Purpose::shape);
    const std::size_t points = std::min(mostSamples, sampler.pointCount());
    std::vector<Point> samples;
    const std::size_t strata = std::min(mostSamples, samplesPerPoint * points);
    sampler.drawStratified(random, {strata, 0, strata}, samples);
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
    const auto vertices = static_cast<int>(shareOfTarget * parameters.targetVertexCount);
    const std::vector<Point3> drawn = toVcg(samples);
    const std::vector<Point3> even = withEvenDensity(drawn);
    const std::size_t distinct = even.size() < drawn.size() ? even.size() : sampler.pointCount();
    CoarseShape shape =
        findCoarseShape(mesh, even, distinct, vertices, parameters.maxHoleSize, workers, progress);
    shape.isTrusted = shape.isTrusted && mesh.vn <= parameters.targetVertexCount;
    return shape;
}

} // namespace neuralmesh
