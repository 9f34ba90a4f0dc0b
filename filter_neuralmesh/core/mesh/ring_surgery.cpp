// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_surgery.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Makes `across` all that v is joined to between the next and the previous vertex of a rim, in
/// place of the faces of a disc or of the gap in v's ring.
void fillBetween(NeuralMesh &mesh, VertexId v, VertexId next, VertexId previous,
                 const std::vector<VertexId> &across)
{
    const NeighbourRing before = mesh.ring(v);
    NeighbourRing &ring = mesh.ring(v);
    ring.clear();
    ring.pushBack(next);
    for (const VertexId u : across)
        ring.pushBack(u);
    ring.pushBack(previous);
    for (int i = before.next(before.find(previous)); before[i] != next; i = before.next(i))
        ring.pushBack(before[i]);
    const bool isGapFilled =
        before[0] == previous && before[before.size() - 1] == next; // the gap was the hole
    if (before.isOpen() && !isGapFilled) {
        ring.rotate(ring.find(before[0]));
        ring.setOpen(true);
    }
}

std::size_t cyclic(std::size_t place, std::size_t size)
{
    return place % size;
}

} // namespace

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
        std::vector<std::size_t> &fan = diagonals[place];
        std::sort(fan.begin(), fan.end(), [&](std::size_t a, std::size_t b) {
            return cyclic(a + size - place, size) < cyclic(b + size - place, size);
        });
        std::vector<VertexId> across;
        for (const std::size_t other : fan)
            across.push_back(rim[other]);
        fillBetween(mesh, rim[place], rim[cyclic(place + 1, size)],
                    rim[cyclic(place + size - 1, size)], across);
    }
    for (const VertexId v : interior)
        mesh.removeVertex(v);
}

bool canOpenDisc(const NeuralMesh &mesh, const std::vector<VertexId> &rim)
{
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const NeighbourRing &ring = mesh.ring(rim[k]);
        const int previous = ring.find(rim[cyclic(k + rim.size() - 1, rim.size())]);
        // Without a face behind the previous vertex there is none to the right of the rim.
        if (ring.isOpen() || ring[ring.next(previous)] == rim[cyclic(k + 1, rim.size())])
            return false;
    }
    return true;
}

void openDisc(NeuralMesh &mesh, const std::vector<VertexId> &rim,
              const std::vector<VertexId> &interior)
{
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const VertexId next = rim[cyclic(k + 1, rim.size())];
        const VertexId previous = rim[cyclic(k + rim.size() - 1, rim.size())];
        const NeighbourRing before = mesh.ring(rim[k]);
        NeighbourRing &ring = mesh.ring(rim[k]);
        ring.clear();
        for (int i = before.find(previous); before[i] != next; i = before.next(i))
            ring.pushBack(before[i]);
        ring.pushBack(next);
        ring.setOpen(true);
    }
    for (const VertexId v : interior)
        mesh.removeVertex(v);
}

} // namespace neuralmesh
