// SPDX-License-Identifier: GPL-3.0-or-later
// The network, which is the mesh: VCG types with a neighbour ring in every vertex.
#pragma once

#include <vector>

#include <vcg/complex/complex.h>

#include "core/mesh/one_ring.h"

namespace neuralmesh {

using Scalar = double;
using Point3 = vcg::Point3<Scalar>;
using Box3 = vcg::Box3<Scalar>;

class NeuralVertex;
class NeuralFace;

struct NeuralTypes
    : vcg::UsedTypes<vcg::Use<NeuralVertex>::AsVertexType, vcg::Use<NeuralFace>::AsFaceType> {};

class NeuralVertex : public vcg::Vertex<NeuralTypes, vcg::vertex::Coord3d, vcg::vertex::BitFlags,
                                        component::OneRing> {};

/// Faces are not kept while the network grows: rebuildFaces() makes them from the rings wherever
/// something outside looks at the mesh.
class NeuralFace : public vcg::Face<NeuralTypes, vcg::face::VertexRef, vcg::face::Normal3d,
                                    vcg::face::FFAdj, vcg::face::Mark, vcg::face::BitFlags> {};

/// Told of every vertex that comes and goes: data of the vertices, and indices of them.
class VertexFollower {
public:
    /// The vertex has its position, and no neighbours yet.
    virtual void vertexAdded(VertexId v) = 0;
    virtual void vertexRemoved(VertexId v) = 0;

protected:
    ~VertexFollower() = default;
};

/// Owns its vertices' slots: that of a removed vertex is used again for the next that is added.
class NeuralMesh : public vcg::tri::TriMesh<std::vector<NeuralVertex>, std::vector<NeuralFace>> {
public:
    // Not by cP(): before 2023, VCGlib's returns a copy, to which this would dangle.
    const Point3 &position(VertexId v) const { return const_cast<NeuralVertex &>(vert[v]).P(); }
    Point3 &position(VertexId v) { return vert[v].P(); }
    const NeighbourRing &ring(VertexId v) const { return vert[v].cR(); }
    NeighbourRing &ring(VertexId v) { return vert[v].R(); }
    int valence(VertexId v) const { return vert[v].cR().size(); }
    bool isOnBoundary(VertexId v) const { return vert[v].cR().isOpen(); }
    bool isLive(VertexId v) const { return v < vert.size() && !vert[v].IsD(); }

    /// Slots in use or free: every id is below this.
    VertexId idBound() const { return static_cast<VertexId>(vert.size()); }

    /// A new vertex without neighbours.
    VertexId addVertex(Point3 position);

    /// Removes a vertex that no other is joined to any more.
    void removeVertex(VertexId v);

    /// Gives the vertices the ids from 0 on, in their order, and lets go of the other slots. Faces
    /// go. Nothing may follow this mesh.
    void compact();

    /// Makes this the other's network: its vertices by the same ids, without faces. Nothing may
    /// follow this mesh.
    void copyNetwork(const NeuralMesh &other);

    /// Removes all. Nothing may follow this mesh.
    void Clear(); // hides VCG's, which knows no slots

    /// From now on, the follower hears of changes, after those that followed before it.
    void follow(VertexFollower &follower) const { followers_.push_back(&follower); }
    void unfollow(VertexFollower &follower) const;

private:
    std::vector<VertexId> freeSlots_; ///< the last is used first
    /// Who follows is no part of what the mesh is.
    mutable std::vector<VertexFollower *> followers_;
};

} // namespace neuralmesh
