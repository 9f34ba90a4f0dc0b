// SPDX-License-Identifier: GPL-3.0-or-later
// Mends torn limbs: a bridge across the tear, and a cut through the strand that held the limb.
//
// A coarse network may cut a limb through and close both stumps, while a strand joins it to the
// body elsewhere: a closed surface of the right genus all the same. No change of one disc can mend
// that. Two do: the facing stumps are joined by a band along the samples, which makes a handle, and
// the handle is cut where that costs least and both ends are closed.
#pragma once

#include "core/mesh/neural_mesh.h"
#include "core/topology/sample_support.h"

namespace neuralmesh {

/// Mends one tear where that brings faces and samples nearer to each other; the mesh keeps its
/// genus and its components and gets no more than `mostVertices` vertices. Returns whether a tear
/// was found that could be mended.
bool mendTear(NeuralMesh &mesh, const SampleSupport &support, int mostVertices);

} // namespace neuralmesh
