// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_table.h"

#include "core/mesh/enumeration.h"

namespace neuralmesh {

FaceTable::FaceTable(const NeuralMesh &mesh) : mesh_(mesh)
{
    std::size_t slots = 0;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        first_.push_back(slots);
        slots += static_cast<std::size_t>(mesh.valence(v));
    }
    atSlot_.resize(slots, noFace);
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        atSlot_[slot(v, a)] = atSlot_[slot(a, b)] = atSlot_[slot(b, v)] = size();
        corners_.push_back({v, a, b});
    });
}

} // namespace neuralmesh
