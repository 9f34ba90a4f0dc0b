// SPDX-License-Identifier: GPL-3.0-or-later
// The fit where there are hardly more points than vertices. Faces that are laid on so few samples
// are free to stand out far beyond them.
#pragma once

#include "core/network/growing_network.h"
#include "neuralmesh/parameters.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Where there are as many vertices as distinct points, and few of both: puts each vertex on a
/// point of its own, the nearest first. Returns whether it did.
bool interpolatePoints(GrowingNetwork &network, const Sampler &sampler, Random &random);

/// The place that a vertex is moved to from where it is, in the bounds of the samples or so little
/// outside as the vertices of a curved surface are. One that is not moved, as no sample reaches it,
/// stays wherever it is.
Point3 movedNearBounds(const Point3 &from, const Point3 &move, const Box3 &bounds);

/// Moves vertices that are further outside the bounds back to that distance. Smoothing moves the
/// few vertices of a small network along their planes as far as these lead. Returns whether there
/// were any. A starting mesh that was given may lie anywhere.
bool bringNearBounds(GrowingNetwork &network, const Sampler &sampler, StartMesh start);
/// The same of a network that does not grow any more.
void bringNearBounds(NeuralMesh &mesh, const Sampler &sampler, StartMesh start);

} // namespace neuralmesh
