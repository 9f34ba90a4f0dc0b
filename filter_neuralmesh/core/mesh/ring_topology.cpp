// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_topology.h"

#include <vcg/complex/allocate.h>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"

namespace neuralmesh {
namespace {

void replaceNeighbour(NeighbourRing &ring, VertexId from, VertexId to)
{
    ring.set(ring.find(from), to);
}

void insertAfter(NeighbourRing &ring, VertexId place, VertexId id)
{
    ring.insert(ring.find(place) + 1, id);
}

void insertBefore(NeighbourRing &ring, VertexId place, VertexId id)
{
    ring.insert(ring.find(place), id);
}

void eraseNeighbour(NeighbourRing &ring, VertexId id)
{
    ring.erase(ring.find(id));
}

int commonNeighbours(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    int count = 0;
    for (const VertexId x : mesh.ring(v))
        count += mesh.ring(u).contains(x) ? 1 : 0;
    return count;
}

} // namespace

OppositeVertices oppositeVertices(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const NeighbourRing &ring = mesh.ring(v);
    const int place = ring.find(u);
    return {ring.hasFaceAfter(place) ? ring[ring.next(place)] : noVertex,
            ring.hasFaceBefore(place) ? ring[ring.previous(place)] : noVertex};
}

bool canCollapse(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const int place = mesh.ring(v).find(u);
    if (place < 0)
        return false;
    const int common = commonNeighbours(mesh, v, u);
    if (!mesh.isOnBoundary(v) && !mesh.isOnBoundary(u))
        // Two neighbours of valence 3 that pass the link condition are corners of a tetrahedron.
        return common == 2 && (mesh.valence(v) > 3 || mesh.valence(u) > 3);
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    const bool isOnBoundary = mesh.ring(v).isBoundaryEdge(place);
    if (common != (isOnBoundary ? 1 : 2))
        return false;
    if (mesh.isOnBoundary(v) && mesh.isOnBoundary(u) && !isOnBoundary)
        return false; // u would join two boundaries
    // An opposite vertex of one face only would be left without any.
    for (const VertexId x : {opposite.left, opposite.right})
        if (x != noVertex && mesh.isOnBoundary(x) && mesh.valence(x) < 3)
            return false;
    return true;
}

void collapse(NeuralMesh &mesh, VertexId v, VertexId u)
{
    // v's ring, from u on: u, left, x1 ... xm, right. u's ring holds left, v, right in a row, and
    // v there gives way to x1 ... xm. On a boundary left or right may be missing, and the gap in
    // v's ring, wherever it is among the x, comes with them.
    const NeighbourRing ring = mesh.ring(v);
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    const int start = ring.find(u);
    NeighbourRing &kept = mesh.ring(u);
    for (const VertexId x : {opposite.left, opposite.right})
        if (x != noVertex)
            eraseNeighbour(mesh.ring(x), v);
    int place = kept.find(v);
    kept.erase(place);
    int gap = -1;
    for (int i = 1; i < ring.size(); ++i) {
        const VertexId x = ring.at(start + i);
        if (ring.isOpen() && x == ring[0])
            gap = place;
        if (x == opposite.left || x == opposite.right)
            continue;
        replaceNeighbour(mesh.ring(x), v, u);
        kept.insert(place++, x);
    }
    if (ring.isOpen() && !kept.isOpen()) {
        kept.rotate(gap);
        kept.setOpen(true);
    }
    mesh.removeVertex(v);
}

void split(NeuralMesh &mesh, VertexId v, int first, int last, VertexId w)
{
    const NeighbourRing ring = mesh.ring(v);
    const int size = ring.size();
    const int begin = first == gapPlace ? 0 : first;
    const int end = last == gapPlace ? size - 1 : last;
    const int span = (end - begin + size) % size;

    NeighbourRing &taken = mesh.ring(w);
    taken.clear();
    taken.setOpen(first == gapPlace || last == gapPlace);
    if (last == gapPlace)
        taken.pushBack(v);
    for (int i = 0; i <= span; ++i)
        taken.pushBack(ring.at(begin + i));
    if (last != gapPlace)
        taken.pushBack(v);

    for (int i = first == gapPlace ? 0 : 1; i < span + (last == gapPlace ? 1 : 0); ++i)
        replaceNeighbour(mesh.ring(ring.at(begin + i)), v, w);
    if (first != gapPlace)
        insertBefore(mesh.ring(ring[first]), v, w);
    if (last != gapPlace)
        insertAfter(mesh.ring(ring[last]), v, w);

    NeighbourRing &kept = mesh.ring(v);
    kept.clear();
    kept.setOpen(ring.isOpen());
    for (int i = ring.isOpen() ? 0 : first; i <= first; ++i) // none where first is the gap
        kept.pushBack(ring[i]);
    kept.pushBack(w);
    for (int i = span; last != gapPlace && i < size - (ring.isOpen() ? begin : 0); ++i)
        kept.pushBack(ring.at(begin + i));
}

bool canFlip(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const int place = mesh.ring(v).find(u);
    if (place < 0 || mesh.ring(v).isBoundaryEdge(place))
        return false;
    for (const VertexId x : {v, u})
        if (mesh.valence(x) <= (mesh.isOnBoundary(x) ? 2 : 3))
            return false;
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    return opposite.left != opposite.right && !mesh.ring(opposite.left).contains(opposite.right);
}

void flip(NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    eraseNeighbour(mesh.ring(v), u);
    eraseNeighbour(mesh.ring(u), v);
    insertAfter(mesh.ring(opposite.left), v, opposite.right);
    insertAfter(mesh.ring(opposite.right), u, opposite.left);
}

bool canCloseOver(const NeuralMesh &mesh, VertexId v)
{
    return mesh.isOnBoundary(v) &&
           !mesh.ring(nextOnBoundary(mesh, v)).contains(previousOnBoundary(mesh, v));
}

void closeOver(NeuralMesh &mesh, VertexId v)
{
    const VertexId next = nextOnBoundary(mesh, v);
    const VertexId previous = previousOnBoundary(mesh, v);
    mesh.ring(previous).insert(0, next);
    mesh.ring(next).pushBack(previous);
    mesh.ring(v).setOpen(false);
}

void rebuildFaces(NeuralMesh &mesh)
{
    mesh.face.clear();
    mesh.fn = 0;
    std::size_t count = 0;
    forEachFace(mesh, [&](VertexId, VertexId, VertexId) { ++count; });
    auto face = vcg::tri::Allocator<NeuralMesh>::AddFaces(mesh, count);
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        face->V(0) = &mesh.vert[v];
        face->V(1) = &mesh.vert[a];
        face->V(2) = &mesh.vert[b];
        ++face;
    });
}

void reverseOrientation(NeuralMesh &mesh)
{
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        reverseRing(mesh, v);
}

void reverseRing(NeuralMesh &mesh, VertexId v)
{
    NeighbourRing &ring = mesh.vert[v].R();
    for (int i = 0, j = ring.size() - 1; i < j; ++i, --j) {
        const VertexId swapped = ring[i];
        ring.set(i, ring[j]);
        ring.set(j, swapped);
    }
}

} // namespace neuralmesh
