// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/convergence.h"

#include <algorithm>

#include "core/result/error_measure.h"
#include "core/shape/quadric_decimation.h"
#include "core/space/plain_points.h"

namespace neuralmesh {
namespace {

/// Samples for each vertex.
constexpr std::size_t samplesPerVertex = 2;

/// Vertices at the first entry.
constexpr int firstDoubling = 8;

} // namespace

void Convergence::noteStart(const NeuralMesh &start, const GrowthParameters &parameters)
{
    int count = firstDoubling;
    while (2 * count < start.vn)
        count *= 2;
    NeuralMesh coarser;
    coarser.copyNetwork(start);
    for (; count >= firstDoubling && count < start.vn; count /= 2) {
        decimate(coarser, count);
        errors_.push_back(errorOf(GrowingNetwork(coarser, toVcg(sampler_.bounds()), parameters)));
    }
    std::reverse(errors_.begin(), errors_.end());
}

void Convergence::note(const GrowingNetwork &network)
{
    if (network.vertexCount() >= firstDoubling << errors_.size())
        errors_.push_back(errorOf(network));
}

double Convergence::errorOf(const GrowingNetwork &network)
{
    const std::size_t samples = samplesPerVertex * static_cast<std::size_t>(network.vertexCount());
    return neuralmesh::errorOf(measureDistances(network, sampler_, random_, samples)).rms;
}

} // namespace neuralmesh
