// SPDX-License-Identifier: GPL-3.0-or-later
// Surface reconstruction with a growing neural network (Ivrissimtzis, Jeong and Seidel, "Using
// Growing Cell Structures for Surface Reconstruction", SMI 2003), in one call.
#pragma once

#include <functional>

#include "neuralmesh/geometry.h"
#include "neuralmesh/parameters.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/report.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// An oriented two-manifold in world coordinates. It is closed, its outside outwards, unless
/// boundaries are learned from the data and stay open.
struct Result {
    Mesh mesh;
    Report report;
};

/// Given each snapshot as it is taken: a mesh like that of the result.
using SnapshotTaker = std::function<void(Mesh snapshot)>;

/// Grows a mesh of exactly parameters.targetVertexCount vertices that learns the sampler's target
/// space, from the start that parameters.startMesh names. It has the topology of that start: of a
/// sphere, or with Topology::learned of the data. The same sampler, parameters and seed give the
/// same mesh, bit for bit.
///
/// Where `progress` says that time is up, the result is the mesh so far, within about half a
/// second: an oriented two-manifold as ever, with report.reachedTarget false. Where there is none
/// yet, it is the solid that growth starts from.
///
/// Snapshots are taken at the vertex counts of parameters.snapshots and never touch the result.
///
/// Throws InvalidParameter for parameters out of range or that do not fit the target space,
/// InvalidStartingMesh for StartMesh::given, Cancelled when `progress` returns false, and what the
/// sampler throws.
Result reconstruct(const Sampler &sampler, const GrowthParameters &parameters = {},
                   const Progress &progress = {}, const SnapshotTaker &takeSnapshot = {});

/// The same from a mesh in world coordinates, roughly in place, whose handles and components the
/// result has. It must be a closed two-manifold with no more vertices than the target; positions
/// that no triangle names are left out. Throws InvalidStartingMesh where it is not one.
/// parameters.startMesh is not looked at.
Result reconstructFrom(const Mesh &startingMesh, const Sampler &sampler,
                       const GrowthParameters &parameters = {}, const Progress &progress = {},
                       const SnapshotTaker &takeSnapshot = {});

} // namespace neuralmesh
