// SPDX-License-Identifier: GPL-3.0-or-later
// The schedule of growth: batches of samples, splits, collapses, and when to stop.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/parameters.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/report.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

struct GrowthReport {
    std::uint64_t signalCount = 0;   // not "signals", which is a macro of Qt
    std::uint64_t splitCount = 0;    ///< vertices that came, those of cut handles among them
    std::uint64_t collapseCount = 0; ///< vertices that went, those of webs among them
    int selfIntersections = 0;       ///< faces of the result that intersect another
    bool reachedTarget = false;
    TimeUp timeUp = TimeUp::no;
    bool keptIdle = false; ///< vertices that win no sample, so that growth came to its end
    TopologyChanges changes;
    /// Distances of fresh samples from the result, in the unit frame.
    double rmsError = 0;
    double maxError = 0;
    double coverage = 0;        ///< share of fresh samples that are near the result
    double unsupportedArea = 0; ///< share of the result's area that is far from all samples
    /// Root mean square distance of samples from the growing network, in the unit frame, as it
    /// reached 8, 16, 32 ... vertices: entry k at 8 * 2^k. Below the count of a starting mesh: of
    /// the start, cut down to so many.
    std::vector<double> convergence;
};

/// Given each snapshot as it is taken, with faces.
using NetworkTaker = std::function<void(std::unique_ptr<NeuralMesh> snapshot)>;

/// Grows `mesh` from parameters.startMesh towards the sampler's target space, to exactly
/// parameters.targetVertexCount vertices. The result is a closed oriented two-manifold, its
/// outside outwards, in the sampler's unit frame, with faces. Its topology is that of the starting
/// mesh: that of the data, genus 0, or that of the mesh that is given.
///
/// Where the data tell no shape that can be trusted, growth starts from the solid.
///
/// With StartMesh::given, `mesh` holds the starting mesh, in the sampler's unit frame. It is drawn
/// to the samples before it grows, which may leave it some vertices fewer.
///
/// Snapshots are taken the first time that the network has the count of vertices, and never touch
/// the result. Where the result is fitted to the surface, so are they, each as if it were the
/// result; where not, they are the network as it is on the way. Those of
/// fewer vertices than a start from the data has grow from a coarser one of their own.
///
/// Where `progress` says that time is up, the result is the mesh so far: of fewer vertices,
/// without the rest of the fit, and the tetrahedron that surrounds the samples where not even the
/// start was made. It is as sound as any; the snapshots that were taken stay.
///
/// Otherwise ends at the target: where splits and collapses come to balance each other before, as
/// happens when the target is close to the number of distinct points, or growth folds and takes
/// twice its time, vertices are no longer removed, and the report's keptIdle is true.
///
/// Throws InvalidParameter for parameters out of range, a target above the number of distinct
/// points, and a target or a snapshot with fewer vertices than the starting mesh; Cancelled when
/// `progress` returns false.
GrowthReport grow(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
                  const Progress &progress = {}, const NetworkTaker &takeSnapshot = {});

} // namespace neuralmesh
