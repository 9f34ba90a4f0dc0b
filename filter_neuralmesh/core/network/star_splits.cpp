// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/star_splits.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/mesh/ring_topology.h"
#include "core/network/valences.h"
#include "core/topology/unsupported_edges.h"

namespace neuralmesh {
namespace {

/// Sum of squared excess valences of the vertices that a split touches, after it.
int spreadAfterSplit(const NeuralMesh &mesh, const StarSplit &s)
{
    const NeighbourRing &ring = mesh.ring(s.vertex);
    const int size = ring.size();
    const bool isAlongBoundary = s.first == gapPlace || s.last == gapPlace;
    const int first = s.first == gapPlace ? 0 : s.first;
    const int last = s.last == gapPlace ? size - 1 : s.last;
    const int span = (last - first + size) % size;
    int spread = squared(span + 2 - idealValence(isAlongBoundary)) +
                 squared(size - span + (isAlongBoundary ? 1 : 2) - idealValence(ring.isOpen()));
    for (const int end : {s.first, s.last})
        if (end != gapPlace)
            spread += squared(valenceExcess(mesh, ring[end]) + 1);
    return spread;
}

/// By how much the split lowers the sum of squared excess valences.
int gainOfSplit(const NeuralMesh &mesh, const StarSplit &s)
{
    int before = squared(valenceExcess(mesh, s.vertex));
    for (const int end : {s.first, s.last})
        before += squared(valenceExcess(mesh, mesh.ring(s.vertex)[end]));
    return before - spreadAfterSplit(mesh, s);
}

/// Takes a split if it leaves less spread than the best so far or is, at the same spread, more
/// even.
class EvenestSplit {
public:
    explicit EvenestSplit(const NeuralMesh &mesh) : mesh_(mesh) {}

    void consider(const StarSplit &split, int unevenness)
    {
        const std::pair<int, int> cost{spreadAfterSplit(mesh_, split), unevenness};
        if (cost < least_) {
            least_ = cost;
            best_ = split;
        }
    }
    const StarSplit &best() const { return best_; }

private:
    const NeuralMesh &mesh_;
    std::pair<int, int> least_{std::numeric_limits<int>::max(), 0};
    StarSplit best_;
};

/// Splits a boundary edge, the first or the last of v's ring, off so many of v's neighbours.
StarSplit splitAlongBoundary(const NeuralMesh &mesh, VertexId v, int edge, int neighbours)
{
    return edge == 0 ? StarSplit{v, gapPlace, neighbours - 1}
                     : StarSplit{v, mesh.valence(v) - neighbours, gapPlace};
}

} // namespace

int longestEdge(const NeuralMesh &mesh, VertexId v)
{
    const NeighbourRing &ring = mesh.ring(v);
    std::pair<bool, Scalar> most(false, -1); // an edge that spans no void is before any that does
    int longest = 0;
    for (int i = 0; i < ring.size(); ++i) {
        const Scalar length = (mesh.position(ring[i]) - mesh.position(v)).SquaredNorm();
        const std::pair<bool, Scalar> edge(!isOverlong(mesh, v, ring[i]), length);
        if (edge > most) {
            longest = i;
            most = edge;
        }
    }
    return longest;
}

StarSplit halvingSplit(const NeuralMesh &mesh, VertexId v, int edge)
{
    const NeighbourRing &ring = mesh.ring(v);
    const int valence = ring.size();
    const int span = std::max(2, valence / 2);
    if (ring.isBoundaryEdge(edge))
        return splitAlongBoundary(mesh, v, edge, span);
    const int before = span / 2;
    const int after = span - before;
    if (ring.isOpen())
        return {v, std::max(0, edge - before), std::min(valence - 1, edge + after)};
    return {v, (edge - before + valence) % valence, (edge + after) % valence};
}

StarSplit balancedSplit(const NeuralMesh &mesh, VertexId v, int edge)
{
    const NeighbourRing &ring = mesh.ring(v);
    const int valence = ring.size();
    EvenestSplit evenest(mesh);
    if (ring.isBoundaryEdge(edge)) {
        for (int neighbours = 2; neighbours <= valence; ++neighbours)
            evenest.consider(splitAlongBoundary(mesh, v, edge, neighbours),
                             std::abs(2 * neighbours - valence));
        return evenest.best();
    }
    const int mostBefore = ring.isOpen() ? edge : valence - 1;
    const int mostAfter = ring.isOpen() ? valence - 1 - edge : valence - 1;
    for (int before = 1; before <= mostBefore; ++before)
        for (int after = 1; after <= mostAfter && before + after < valence; ++after)
            evenest.consider({v, (edge - before + valence) % valence, (edge + after) % valence},
                             std::abs(before - after));
    return evenest.best();
}

StarSplit bestRaisingSplit(const NeuralMesh &mesh, VertexId v)
{
    StarSplit best;
    int most = 0;
    for (const VertexId u : mesh.ring(v)) {
        const int valence = mesh.valence(u);
        const int place = mesh.ring(u).find(v);
        const bool isOpen = mesh.isOnBoundary(u);
        const auto consider = [&](const StarSplit &split) {
            const int gain = gainOfSplit(mesh, split);
            if (gain > most) {
                most = gain;
                best = split;
            }
        };
        // A new vertex and an old one of valence 4 at the least; on a boundary, short of the gap.
        for (int span = 2; span + 2 <= valence; ++span) {
            if (!isOpen || place + span < valence)
                consider({u, place, (place + span) % valence});
            if (!isOpen || place >= span)
                consider({u, (place + valence - span) % valence, place});
        }
    }
    return best;
}

Point3 middleOfSpan(const NeuralMesh &mesh, const StarSplit &star)
{
    const NeighbourRing &ring = mesh.ring(star.vertex);
    const int span = (star.last - star.first + ring.size()) % ring.size();
    Point3 sum(0, 0, 0);
    for (int i = 0; i <= span; ++i)
        sum += mesh.position(ring.at(star.first + i));
    return (mesh.position(star.vertex) + sum / (span + 1)) / 2;
}

} // namespace neuralmesh
