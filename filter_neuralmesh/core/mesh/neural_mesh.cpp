// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/neural_mesh.h"

#include <algorithm>
#include <cassert>

#include <vcg/complex/allocate.h>

namespace neuralmesh {

VertexId NeuralMesh::addVertex(Point3 at)
{
    VertexId v = idBound();
    if (freeSlots_.empty()) {
        vcg::tri::Allocator<NeuralMesh>::AddVertex(*this, at);
    } else {
        v = freeSlots_.back();
        freeSlots_.pop_back();
        vert[v].ClearD();
        position(v) = at;
        ++vn;
    }
    for (VertexFollower *follower : followers_)
        follower->vertexAdded(v);
    return v;
}

void NeuralMesh::removeVertex(VertexId v)
{
    ring(v).clear();
    vcg::tri::Allocator<NeuralMesh>::DeleteVertex(*this, vert[v]);
    freeSlots_.push_back(v);
    for (VertexFollower *follower : followers_)
        follower->vertexRemoved(v);
}

void NeuralMesh::copyNetwork(const NeuralMesh &other)
{
    Clear();
    vert = other.vert;
    vn = other.vn;
    for (VertexId v = 0; v < idBound(); ++v)
        if (!isLive(v))
            freeSlots_.push_back(v);
}

void NeuralMesh::Clear()
{
    assert(followers_.empty());
    TriMesh::Clear();
    freeSlots_.clear();
}

void NeuralMesh::unfollow(VertexFollower &follower) const
{
    followers_.erase(std::find(followers_.begin(), followers_.end(), &follower));
}

} // namespace neuralmesh
