// SPDX-License-Identifier: GPL-3.0-or-later
// How far the samples reach beyond the boundaries of the mesh, or fall short of them.
//
// Samples beyond a boundary are a one-sided sign: drawn to them alone, the boundary would run away
// from noise, and drawn to all samples around it, as growth draws it, it stays a share of an edge
// inside. Here the samples of a strip along each boundary edge are taken for evenly spread from the
// strip's inner side to the edge of the target space. Then the middle between the two is their
// mean, and tells where that edge is.
#pragma once

#include <Eigen/Dense>

#include "core/mesh/vertex_data.h"
#include "core/network/star_projection.h"

namespace neuralmesh {

class BoundaryReach {
public:
    explicit BoundaryReach(const NeuralMesh &mesh) : mesh_(mesh), strips_(mesh) {}

    /// Begins a sweep: what was seen so far counts less. A sweep has a handful of samples for each
    /// boundary edge. All sweeps together know no more than so many sweeps of samples that were
    /// never drawn twice.
    void fade(double mostInformation);

    /// Takes in a sample by its projection.
    void add(const StarProjection &p);

    /// Follows the boundary from where it was.
    void follow(const VertexData<Point3> &before);

    /// A linear system for the displacement of a vertex: the directions that are determined, each
    /// with its precision.
    struct Pull {
        Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
        Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    };

    /// What the strips along both boundary edges of a vertex on a boundary say: across each edge,
    /// within the surface. Without samples it is expected in the middle of its neighbours along the
    /// boundary, to which `toCentre` leads.
    Pull pull(VertexId v, const Eigen::Vector3d &toCentre) const;

private:
    /// What the samples along a boundary edge say of one of its ends; sums, weighted. Offsets are
    /// distances from the edge, outwards within the plane of its face.
    struct Share {
        double weight = 0;
        double offset = 0;
        double depth = 0; ///< of the strip in which the samples were looked for
        double samples = 0;
    };
    /// Along the boundary edge that starts at a vertex.
    struct Strip {
        Share start, end;
    };

    void addToStrip(VertexId start, VertexId end, VertexId apex, const StarProjection &p);
    void pullAcross(VertexId start, const Share &share, const Eigen::Vector3d &toCentre,
                    Pull &pull) const;

    const NeuralMesh &mesh_;
    VertexData<Strip> strips_;
    double sweeps_ = 0;       ///< that are remembered, the older the less
    double independence_ = 1; ///< share of the samples that tell something new
};

} // namespace neuralmesh
