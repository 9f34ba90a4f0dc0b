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

void NeuralMesh::compact()
{
    assert(followers_.empty());
    std::vector<VertexId> idNow(vert.size(), noVertex);
    std::vector<NeuralVertex> live;
    live.reserve(static_cast<std::size_t>(vn));
    for (VertexId v = 0; v < idBound(); ++v)
        if (isLive(v)) {
            idNow[v] = static_cast<VertexId>(live.size());
            live.push_back(std::move(vert[v]));
        }
    for (NeuralVertex &vertex : live)
        for (int place = 0; place < vertex.cR().size(); ++place)
            vertex.R().set(place, idNow[vertex.cR()[place]]);
    Clear();
    vert = std::move(live);
    vn = static_cast<int>(vert.size());
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
