// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers the faces that the rings stand for, for searches from face to face.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

using FaceId = std::uint32_t;
inline constexpr FaceId noFace = 0xffffffffU;

/// Valid until the mesh's connectivity changes.
class FaceTable {
public:
    explicit FaceTable(const NeuralMesh &mesh);

    FaceId size() const { return static_cast<FaceId>(corners_.size()); }
    const Corners &corners(FaceId face) const { return corners_[face]; }

    /// The face (a, b, x) to the left of edge a -> b, or noFace where a boundary is. They must be
    /// neighbours.
    FaceId leftOf(VertexId a, VertexId b) const { return atSlot_[slot(a, b)]; }

    /// The face (v, a, b) of neighbours a, b at places i and i + 1 of v's ring, or noFace.
    FaceId around(VertexId v, int i) const { return atSlot_[first_[v] + static_cast<FaceId>(i)]; }

private:
    std::size_t slot(VertexId a, VertexId b) const
    {
        return first_[a] + static_cast<std::size_t>(mesh_.ring(a).find(b));
    }

    const NeuralMesh &mesh_;
    std::vector<std::size_t> first_; ///< by vertex: slot of its ring's first place
    std::vector<FaceId> atSlot_;
    std::vector<Corners> corners_;
};

} // namespace neuralmesh
