// SPDX-License-Identifier: GPL-3.0-or-later
// The schedule of growth: batches of samples, splits, collapses, and when to stop.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "growth_parameters.h"
#include "neural_mesh.h"
#include "progress.h"
#include "sampler.h"

namespace neuralmesh {

struct GrowthReport {
    std::uint64_t signalCount = 0; // not "signals", which is a macro of Qt
    std::uint64_t splitCount = 0;
    std::uint64_t collapseCount = 0;
    bool reachedTarget = false;
    /// Distances of fresh samples from the result, in the unit frame.
    double rmsError = 0;
    double maxError = 0;
    /// Root mean square distance of samples from the growing network, in the unit frame, as it
    /// reached 8, 16, 32 ... vertices: entry k at 8 * 2^k.
    std::vector<double> convergence;
};

/// Grows `mesh` from a tetrahedron towards the sampler's target space, to exactly
/// parameters.targetVertexCount vertices. The result is a closed oriented two-manifold of genus 0,
/// its outside outwards, in the sampler's unit frame, with faces.
///
/// Always ends: where splits and collapses come to balance each other before the target is
/// reached, as happens when the target is close to the number of distinct points, growth stops
/// with what it has and reports reachedTarget = false.
///
/// Throws InvalidInput for parameters out of range and a target above the number of distinct
/// points, Cancelled when `progress` returns false.
GrowthReport grow(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
                  const Progress &progress = {});

} // namespace neuralmesh
