// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_topology.h"

#include <algorithm>

#include <vcg/complex/allocate.h>

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
    return {ring[ring.next(place)], ring[ring.previous(place)]};
}

bool canCollapse(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    // Two neighbours of valence 3 that pass the link condition are corners of a tetrahedron.
    return mesh.ring(v).contains(u) && commonNeighbours(mesh, v, u) == 2 &&
           (mesh.valence(v) > 3 || mesh.valence(u) > 3);
}

void collapse(NeuralMesh &mesh, VertexId v, VertexId u)
{
    // v's ring, from u on: u, left, x1 ... xm, right. u's ring holds left, v, right in a row, and
    // v there gives way to x1 ... xm.
    const NeighbourRing ring = mesh.ring(v);
    const int start = ring.find(u);
    const int valence = ring.size();
    NeighbourRing &kept = mesh.ring(u);
    eraseNeighbour(mesh.ring(ring.at(start + 1)), v);
    eraseNeighbour(mesh.ring(ring.at(start + valence - 1)), v);
    int place = kept.find(v);
    kept.erase(place);
    for (int i = 2; i + 1 < valence; ++i) {
        const VertexId x = ring.at(start + i);
        replaceNeighbour(mesh.ring(x), v, u);
        kept.insert(place++, x);
    }
    mesh.removeVertex(v);
}

void split(NeuralMesh &mesh, VertexId v, int first, int last, VertexId w)
{
    const NeighbourRing ring = mesh.ring(v);
    const int span = (last - first + ring.size()) % ring.size();
    NeighbourRing &taken = mesh.ring(w);
    taken.clear();
    for (int i = 0; i <= span; ++i)
        taken.pushBack(ring.at(first + i));
    taken.pushBack(v);

    for (int i = 1; i < span; ++i)
        replaceNeighbour(mesh.ring(ring.at(first + i)), v, w);
    NeighbourRing &firstRing = mesh.ring(ring[first]);
    firstRing.insert(firstRing.find(v), w);
    insertAfter(mesh.ring(ring[last]), v, w);

    NeighbourRing &kept = mesh.ring(v);
    kept.clear();
    kept.pushBack(ring[first]);
    kept.pushBack(w);
    for (int i = span; i < ring.size(); ++i)
        kept.pushBack(ring.at(first + i));
}

bool canFlip(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    if (mesh.valence(v) <= 3 || mesh.valence(u) <= 3 || !mesh.ring(v).contains(u))
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

void refillDisc(NeuralMesh &mesh, const std::vector<VertexId> &rim,
                const std::vector<VertexId> &interior, const std::vector<LoopTriangle> &triangles)
{
    const std::size_t size = rim.size();
    // Each diagonal is once the longest side, in places, of a triangle.
    std::vector<std::vector<std::size_t>> diagonals(size);
    for (const LoopTriangle &triangle : triangles) {
        const auto i = static_cast<std::size_t>(triangle[0]);
        const auto j = static_cast<std::size_t>(triangle[2]);
        if (i == 0 && j + 1 == size)
            continue;
        diagonals[i].push_back(j);
        diagonals[j].push_back(i);
    }
    for (std::size_t place = 0; place < size; ++place) {
        // Counter-clockwise: the next vertex of the rim, the diagonals, the previous vertex, then
        // the neighbours outside the disc.
        const VertexId next = rim[(place + 1) % size];
        const VertexId previous = rim[(place + size - 1) % size];
        std::vector<std::size_t> &fan = diagonals[place];
        std::sort(fan.begin(), fan.end(), [&](std::size_t a, std::size_t b) {
            return (a + size - place) % size < (b + size - place) % size;
        });
        const NeighbourRing before = mesh.ring(rim[place]);
        NeighbourRing &ring = mesh.ring(rim[place]);
        ring.clear();
        ring.pushBack(next);
        for (const std::size_t other : fan)
            ring.pushBack(rim[other]);
        ring.pushBack(previous);
        for (int i = before.next(before.find(previous)); before[i] != next; i = before.next(i))
            ring.pushBack(before[i]);
    }
    for (const VertexId v : interior)
        mesh.removeVertex(v);
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
    for (NeuralVertex &vertex : mesh.vert) {
        NeighbourRing &ring = vertex.R();
        for (int i = 0, j = ring.size() - 1; i < j; ++i, --j) {
            const VertexId swapped = ring[i];
            ring.set(i, ring[j]);
            ring.set(j, swapped);
        }
    }
}

} // namespace neuralmesh
