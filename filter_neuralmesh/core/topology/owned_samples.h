// SPDX-License-Identifier: GPL-3.0-or-later
// The samples that are nearer to a patch of the mesh than to all that is beside it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/mesh/face_table.h"
#include "core/mesh/neural_mesh.h"
#include "core/space/point_grid.h"
#include "core/topology/sample_support.h"
#include "core/topology/unsupported_patches.h"

namespace neuralmesh {

/// Holds references: nothing of the mesh may change meanwhile. Each sample's nearest point of the
/// mesh is looked for once, when it is first needed.
class OwnedSamples {
public:
    OwnedSamples(const NeuralMesh &mesh, const FaceTable &faces, const SampleSupport &support);

    /// The squared distance from the mesh of a sample that is nearest to the patch found last, or
    /// to its rim. None of another sample. Looked at are the faces around a sample's nearest
    /// vertex.
    std::optional<Scalar> squaredDistance(SampleId sample, const PatchSearch &patches);

    /// How many samples are nearest to the patch, which must be the one found last.
    std::size_t count(const Patch &patch, const PatchSearch &patches);

    /// So many samples a face of the mesh has in the mean.
    double perFace() const;

private:
    /// The nearest point of the mesh: on a face, an edge or a vertex. Other corners are noVertex.
    struct Foot {
        std::array<VertexId, 3> corners{noVertex, noVertex, noVertex};
        Scalar squaredDistance = 0;
    };

    const Foot &footOf(SampleId sample);
    bool isOnPatch(const Foot &foot, const PatchSearch &patches) const;

    const NeuralMesh &mesh_;
    const FaceTable &faces_;
    const SampleSupport &support_;
    std::optional<PointGrid> vertices_; ///< made when it is first needed
    std::vector<Foot> feet_;            ///< by sample; without corners where it was not asked for
};

} // namespace neuralmesh
