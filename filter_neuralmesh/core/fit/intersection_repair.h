// SPDX-License-Identifier: GPL-3.0-or-later
// Moves vertices until no face intersects another, as far as that goes.
#pragma once

#include "core/mesh/vertex_data.h"
#include "core/network/growing_network.h"

namespace neuralmesh {

/// First puts vertices of intersecting faces back, half-way and then whole, to where they were
/// before they were moved: where two walls are closer to each other than the vertices, samples of
/// one pull at faces of the other. What intersected there too is smoothed: its vertices go half-way
/// to the middle of their neighbours, and later those around them. Connectivity stays.
///
/// Returns how many faces still intersect another.
int repairIntersections(GrowingNetwork &network, const VertexData<Point3> &before);

} // namespace neuralmesh
