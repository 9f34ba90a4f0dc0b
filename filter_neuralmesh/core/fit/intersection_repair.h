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

/// The vertices before and after each one on a boundary, along it; of others, noVertex.
class RimNeighbours {
public:
    explicit RimNeighbours(const NeuralMesh &mesh);

    bool isOnRim(VertexId v) const { return before_[v] != noVertex; }
    VertexId before(VertexId v) const { return before_[v]; }
    VertexId after(VertexId v) const { return after_[v]; }

private:
    VertexData<VertexId> before_, after_;
};

/// Smooths the vertices whose star is folded, of these, until none is, as far as that goes: a sheet
/// cannot be parted from a copy of it there.
void unfold(GrowingNetwork &network, const std::vector<VertexId> &sheet);

/// After boundaries, those of `rim`, have been closed by discs: smooths the rim along itself where
/// it is so ragged that faces of the disc cross those beside it. Other vertices stay but where that
/// is not enough, as where a rim touches itself: there all are smoothed. Returns how many faces
/// intersect another.
int smoothRim(GrowingNetwork &network, const RimNeighbours &rim);

} // namespace neuralmesh
