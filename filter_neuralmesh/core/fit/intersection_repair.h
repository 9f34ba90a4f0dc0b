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

/// Smooths the vertices whose star is folded, of these, until none is, as far as that goes: a sheet
/// cannot be parted from a copy of it there.
void unfold(GrowingNetwork &network, const std::vector<VertexId> &sheet);

/// Smooths what intersects, as repairIntersections does where nothing is to be put back: discs that
/// have closed a ragged boundary cross the faces beside it. Returns how many faces still intersect
/// another.
int smoothIntersections(GrowingNetwork &network);

} // namespace neuralmesh
