// SPDX-License-Identifier: GPL-3.0-or-later
// Which edge of a vertex to collapse so that valences come out even.
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// The neighbour into which v's collapse has the least regularity error (equation 9 of the paper),
/// or noVertex where none of v's edges may collapse. Of equals, the first in the ring.
VertexId bestCollapse(const NeuralMesh &mesh, VertexId v);

/// The same, among those collapses that leave the surface as it is in all that can be seen: no
/// face turns by more than 35 degrees, v hardly stands out from what is left, and no angle falls
/// below the smallest around v or 20 degrees.
VertexId bestCollapseOnSurface(const NeuralMesh &mesh, VertexId v);

struct VertexCollapse {
    VertexId vertex = noVertex;
    VertexId into = noVertex;
};

/// The collapse of any vertex that keeps the surface, if there is one, and else any at all; those
/// that even out valences first. Its vertex is noVertex where none may collapse.
VertexCollapse leastVisibleCollapse(const NeuralMesh &mesh);

/// Vertices of valence 5 whose collapse lowers the sum of squared excess valences, most first:
/// where two of them are neighbours between two of valence 7, all four become 6.
std::vector<VertexId> mostRegularCollapses(const NeuralMesh &mesh);

} // namespace neuralmesh
