// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_table.h"

namespace neuralmesh {

FaceTable::FaceTable(const NeuralMesh &mesh) : mesh_(mesh)
{
    std::size_t slots = 0;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        first_.push_back(slots);
        slots += static_cast<std::size_t>(mesh.valence(v));
    }
    atSlot_.resize(slots);
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        const NeighbourRing &ring = mesh.ring(v);
        for (int i = 0; i < ring.size(); ++i) {
            const VertexId a = ring[i];
            const VertexId b = ring[ring.next(i)];
            if (v > a || v > b)
                continue;
            atSlot_[slot(v, a)] = atSlot_[slot(a, b)] = atSlot_[slot(b, v)] = size();
            corners_.push_back({v, a, b});
        }
    }
}

} // namespace neuralmesh
