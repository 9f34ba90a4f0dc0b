// SPDX-License-Identifier: GPL-3.0-or-later
// What growth starts from.
#pragma once

#include "core/mesh/neural_mesh.h"
#include "core/parallel/workers.h"
#include "neuralmesh/parameters.h"
#include "neuralmesh/random.h"
#include "neuralmesh/report.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Of the time of a run, for a start from the data.
constexpr double shareOfStart = 0.05;

struct Start {
    LearnedShape shape = LearnedShape::notAsked;
    bool isShapeClear = true;
    /// Gaps in the data at which the mesh is open.
    int gaps = 0;
    /// Whether the mesh has a shape, of the data or given, that it is to keep: no solid.
    bool hasShape = false;
};

/// Makes `mesh` the starting mesh: of the data, the solid where the data tell no shape that can be
/// trusted or are not asked, or as it is with StartMesh::given.
///
/// Throws InvalidParameter where the target has fewer vertices than it, or a snapshot of what does
/// not start from the data; FlatTarget where nothing but a closed surface could come of points on a
/// plane; Cancelled. Where the watch of the workers finds that time is up
/// before there is a shape, it is the solid.
Start makeStart(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
                Random &random, Workers &workers);

/// Throws InvalidParameter where the target has more vertices than there are distinct points, and
/// TooLittleMemory.
void requireEnoughPoints(const Sampler &sampler, int target);

/// Throws InvalidParameter where the count of vertices that a parameter asks for is below that of
/// the starting mesh.
void requireAtLeast(Parameter parameter, int count, int startingVertices);

} // namespace neuralmesh
