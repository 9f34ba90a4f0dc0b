// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes of the input's points, averaged onto the vertices of the network.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/space/vertex_grid.h"

namespace neuralmesh {

/// What a point has: red, green, blue and alpha, and quality, each in units of its own.
using AttributeValues = std::array<double, 5>;

/// Each point counts for the vertex nearest to it, the less the further off it is, so that points
/// far from the surface colour nothing. A vertex that is nearest to none takes the mean of its
/// neighbours.
class AttributeTransfer {
public:
    /// More points than this add nothing that can be seen.
    static constexpr std::size_t pointsPerVertex = 64;

    /// `bounds` are those of the target space. The mesh must outlive this and stay as it is.
    AttributeTransfer(const NeuralMesh &mesh, const Box3 &bounds);

    /// A point in the unit frame. Fast where it is near the last one.
    void add(const Point3 &point, const AttributeValues &values);

    /// Values of the live vertices, in order of their ids. Needs at least one point.
    std::vector<AttributeValues> average() const;

private:
    struct Sum {
        double weight = 0;
        AttributeValues values{}; ///< weighted
    };

    void spreadToEmpty(std::vector<Sum> &sums) const;

    const NeuralMesh &mesh_;
    VertexGrid grid_;
    double squaredEdge_;    ///< mean over all edges
    std::vector<Sum> sums_; ///< by id
    VertexId lastNearest_ = noVertex;
};

} // namespace neuralmesh
