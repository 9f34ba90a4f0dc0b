// SPDX-License-Identifier: GPL-3.0-or-later
// Bridges between stumps: bands of faces that put a limb together again.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/face_table.h"
#include "core/mesh/neural_mesh.h"
#include "core/topology/sample_support.h"
#include "core/topology/unsupported_patches.h"

namespace neuralmesh {

/// A patch that may close a limb cut short. Squared distances are from the middles of edges to the
/// nearest sample.
struct Stump {
    Stump(const NeuralMesh &mesh, const FaceTable &table, const SampleSupport &support,
          Patch itsPatch);

    Patch patch;
    std::vector<Corners> faces;
    std::vector<std::array<double, 3>> distances; ///< of each face's edges, the first from corner 0
    std::vector<double> rimDistances;             ///< of the edges of the rim, by where they start
    Box3 bounds;                                  ///< of the rim
};

struct Bridge {
    std::vector<std::pair<int, int>> rungs; ///< as of AnnulusTriangulation, between the two rims
    double gain = 0;                        ///< in area times squared distance
};

/// The bridge between two stumps apart from each other, where that brings faces and samples much
/// nearer to each other than the stumps do.
std::optional<Bridge> betterBridge(const NeuralMesh &mesh, const SampleSupport &support,
                                   const Stump &first, const Stump &second);

} // namespace neuralmesh
