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

void bridgeDiscs(NeuralMesh &mesh, const std::vector<VertexId> &firstRim,
                 const std::vector<VertexId> &secondRim,
                 const std::vector<std::pair<int, int>> &rungs)
{
    const std::size_t count = rungs.size();
    std::vector<std::vector<VertexId>> acrossFirst(firstRim.size());
    std::vector<std::vector<VertexId>> acrossSecond(secondRim.size());
    // Start where the first rim has just moved on and later where the second has, so that the
    // rungs of each vertex come in one run.
    std::size_t startOfFirst = 0;
    std::size_t startOfSecond = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const auto &[i, j] = rungs[k];
        const auto &[i0, j0] = rungs[cyclic(k + count - 1, count)];
        if (i != i0)
            startOfFirst = k;
        if (j != j0)
            startOfSecond = k;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const auto &[i, j] = rungs[cyclic(startOfFirst + count - 1 - k, count)];
        acrossFirst[static_cast<std::size_t>(i)].push_back(secondRim[static_cast<std::size_t>(j)]);
        const auto &[p, q] = rungs[cyclic(startOfSecond + k, count)];
        acrossSecond[static_cast<std::size_t>(q)].push_back(firstRim[static_cast<std::size_t>(p)]);
    }
    const auto join = [&](const std::vector<VertexId> &rim,
                          const std::vector<std::vector<VertexId>> &across) {
        for (std::size_t i = 0; i < rim.size(); ++i)
            fillBetween(mesh, rim[i], rim[cyclic(i + 1, rim.size())],
                        rim[cyclic(i + rim.size() - 1, rim.size())], across[i]);
    };
    join(firstRim, acrossFirst);
    join(secondRim, acrossSecond);
}

bool canCut(const NeuralMesh &mesh, const std::vector<VertexId> &loop)
{
    const std::size_t size = loop.size();
    if (size < 3)
        return false;
    for (std::size_t k = 0; k < size; ++k) {
        const NeighbourRing &ring = mesh.ring(loop[k]);
        const int next = ring.find(loop[cyclic(k + 1, size)]);
        const int previous = ring.find(loop[cyclic(k + size - 1, size)]);
        if (ring.isOpen() || next < 0 || previous < 0 || ring.next(next) == previous ||
            ring.next(previous) == next)
            return false;
    }
    return true;
}

std::vector<VertexId> cutOpen(NeuralMesh &mesh, const std::vector<VertexId> &loop)
{
    const std::size_t size = loop.size();
    std::vector<VertexId> copies;
    for (const VertexId v : loop)
        copies.push_back(mesh.addVertex(mesh.position(v)));
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t after = cyclic(k + 1, size);
        const std::size_t before = cyclic(k + size - 1, size);
        // Counter-clockwise from the next vertex of the loop: what lies to its left, the previous
        // vertex, what lies to its right.
        const NeighbourRing whole = mesh.ring(loop[k]);
        const int previous = whole.find(loop[before]);
        NeighbourRing &left = mesh.ring(loop[k]);
        left.clear();
        for (int i = whole.find(loop[after]); i != previous; i = whole.next(i))
            left.pushBack(whole[i]);
        left.pushBack(loop[before]);
        left.setOpen(true);
        NeighbourRing &right = mesh.ring(copies[k]);
        right.clear();
        right.pushBack(copies[before]);
        for (int i = whole.next(previous); whole[i] != loop[after]; i = whole.next(i)) {
            right.pushBack(whole[i]);
            NeighbourRing &other = mesh.ring(whole[i]);
            other.set(other.find(loop[k]), copies[k]);
        }
        right.pushBack(copies[after]);
        right.setOpen(true);
    }
    return copies;
}

} // namespace neuralmesh
