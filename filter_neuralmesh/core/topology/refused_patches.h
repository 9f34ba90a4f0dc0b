// SPDX-License-Identifier: GPL-3.0-or-later
// Where patches were looked at and left, so that they are not looked at again before the mesh
// moves.
#pragma once

#include "core/mesh/face_table.h"
#include "core/mesh/neural_mesh.h"
#include "core/mesh/vertex_data.h"
#include "core/topology/unsupported_patches.h"

namespace neuralmesh {

/// Follows the mesh, which must outlive it.
class RefusedPatches {
public:
    explicit RefusedPatches(const NeuralMesh &mesh);

    /// Forgets all of them.
    void clear() { places_.reset(); }

    /// A patch is to stay as long as its vertices stand where they stand now.
    void add(const Patch &patch);

    /// Whether both ends of an edge were in patches that are to stay, and have hardly moved since.
    bool holds(VertexId a, VertexId b) const;

private:
    const NeuralMesh &mesh_;
    VertexData<Point3> places_; ///< of the vertices then
};

} // namespace neuralmesh
