// SPDX-License-Identifier: GPL-3.0-or-later
// Edges that span a void, and how to get rid of them.
//
// While the network is coarse it spans the gaps between limbs like a film. As it grows, the film's
// vertices stop winning and are collapsed, and what remains is a web: long edges from one side of
// the gap to the other, two sheets back to back. No sample pulls at them, and collapsing and
// splitting alone keeps them for ever. But the rim of a web can be flipped into the short edge
// between its two opposite vertices, which lie on one side: the web retracts by a step, and so on
// until it has gone, like a zip. Where the zip jams, web_removal.h takes the whole web out.
#pragma once

#include "core/mesh/neural_mesh.h"
#include "core/topology/sample_support.h"

namespace neuralmesh {

/// Whether edge (v, u) runs along the target space: a sample lies near its middle, compared with
/// its length.
bool isSupported(const NeuralMesh &mesh, const SampleSupport &support, VertexId v, VertexId u);

/// Share of the mesh's area whose faces are far from all samples: of a web, or of the sheet that
/// closes an open surface.
double unsupportedShare(const NeuralMesh &mesh, const SampleSupport &support);

/// Whether edge (v, u) is several times as long as the spacing at its ends, as edges across a void
/// are and edges along the surface are not. Needs no samples.
bool isOverlong(const NeuralMesh &mesh, VertexId v, VertexId u);

/// Flips edges that are overlong or not supported into shorter ones until no such flip is left.
/// Returns the number of flips. The sum of the edge lengths falls with each, so this ends.
int retractWebs(NeuralMesh &mesh, const SampleSupport &support);

} // namespace neuralmesh
