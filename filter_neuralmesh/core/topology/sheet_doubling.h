// SPDX-License-Identifier: GPL-3.0-or-later
// Closes open sheets by a second one, back to back with the first.
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/mesh/vertex_data.h"

namespace neuralmesh {

/// The components that a second sheet closes better than discs over their boundaries. Doubling
/// costs the area of the sheet; a disc, which no sample supports, its own.
class OpenSheets {
public:
    /// None.
    explicit OpenSheets(const NeuralMesh &mesh) : mesh_(mesh), isOfSheet_(mesh, 0) {}

    /// Judges the components as they are. From now on they stay sheets, whatever becomes of them.
    /// Returns how many there are.
    int judge();

    bool isEmpty() const { return isEmpty_; }

    /// Takes a vertex that a split has made to the component of its neighbours.
    void take(VertexId v) { isOfSheet_[v] = isOfSheet_[mesh_.ring(v)[0]]; }

    /// Vertices that the sheet behind would add where v is: one inside a sheet, none on its
    /// boundary, which both share.
    int copiesOf(VertexId v) const { return isOfSheet_[v] != 0 && !mesh_.isOnBoundary(v) ? 1 : 0; }

    /// Vertices that doubling all sheets would add.
    int copies() const;

    /// Of all sheets, whether or not their vertices were all taken.
    std::vector<VertexId> vertices() const;

private:
    const NeuralMesh &mesh_;
    VertexData<char> isOfSheet_;
    bool isEmpty_ = true;
};

/// A vertex inside a sheet, and its copy behind it.
using Doubled = std::pair<VertexId, VertexId>;

/// Sews a mirrored copy of each component in `sheets`, all of its vertices, to its boundary, which
/// leaves it closed, with the copies where the vertices are. An edge across the sheet from boundary
/// to boundary would be one of four faces: on one of the two sides it is flipped, so that the sides
/// do not pass through each other once they are parted. A component where no flip can help, or that
/// is a single triangle, stays as it is.
std::vector<Doubled> doubleSheets(NeuralMesh &mesh, const std::vector<VertexId> &sheets);

} // namespace neuralmesh
