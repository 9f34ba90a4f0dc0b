// SPDX-License-Identifier: GPL-3.0-or-later
// Takes out webs: discs of faces across a void are replaced by faces along the target space.
//
// A web between two limbs, front and back sheet and the rim that joins them, is a disc. The loop
// around it runs along one limb and back along the other, and can be filled in many ways. The web
// is one, the missing walls of the limbs are another, and the samples say which is right. Both fill
// the same loop, so the topology stays.
#pragma once

#include <vector>

#include "core/mesh/loop_triangulation.h"
#include "core/mesh/neural_mesh.h"
#include "core/topology/refused_patches.h"
#include "core/topology/sample_support.h"

namespace neuralmesh {

/// A disc of the mesh, and what is to take its place.
struct Refilling {
    std::vector<VertexId> rim;           ///< the loop around the disc, its faces to the left
    std::vector<VertexId> interior;      ///< vertices that go
    std::vector<LoopTriangle> triangles; ///< places in the rim
};

/// Where the mesh spans voids and could do better. The discs have no vertices in common, so the
/// refillings can be applied one after the other. Larger patches for which nothing better is found
/// are added to those refused before, and are not looked at again until the mesh moves there.
std::vector<Refilling> findWebs(const NeuralMesh &mesh, const SampleSupport &support,
                                RefusedPatches &refused);

} // namespace neuralmesh
