// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/star_splits.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/network/valences.h"
#include "core/topology/unsupported_edges.h"

namespace neuralmesh {
namespace {

/// By how much the split lowers the sum of (valence - 6)².
int gainOfSplit(const NeuralMesh &mesh, const StarSplit &s)
{
    const NeighbourRing &ring = mesh.ring(s.vertex);
    const int span = (s.last - s.first + ring.size()) % ring.size();
    int gain = valenceSpread(ring.size()) - valenceSpread(span + 2) -
               valenceSpread(ring.size() - span + 2);
    for (const int end : {s.first, s.last}) {
        const int valence = mesh.valence(ring[end]);
        gain += valenceSpread(valence) - valenceSpread(valence + 1);
    }
    return gain;
}

} // namespace

int longestEdge(const NeuralMesh &mesh, VertexId v)
{
    const NeighbourRing &ring = mesh.ring(v);
    int longest = 0;
    Scalar longestSquared = -1;
    for (int i = 0; i < ring.size(); ++i) {
        const Scalar d = (mesh.position(ring[i]) - mesh.position(v)).SquaredNorm();
        if (d > longestSquared && (longestSquared < 0 || !isOverlong(mesh, v, ring[i]))) {
            longest = i;
            longestSquared = d;
        }
    }
    return longest;
}

StarSplit halvingSplit(const NeuralMesh &mesh, VertexId v, int edge)
{
    const int valence = mesh.valence(v);
    const int span = std::max(2, valence / 2);
    const int before = span / 2;
    return {v, (edge - before + valence) % valence, (edge + span - before) % valence};
}

StarSplit balancedSplit(const NeuralMesh &mesh, VertexId v, int edge)
{
    const NeighbourRing &ring = mesh.ring(v);
    const int valence = ring.size();
    StarSplit best;
    std::pair<int, int> least{std::numeric_limits<int>::max(), 0};
    for (int before = 1; before + 1 < valence; ++before)
        for (int after = 1; before + after < valence; ++after) {
            const int span = before + after;
            const int first = (edge - before + valence) % valence;
            const int last = (edge + after) % valence;
            const int spread = squared(span + 2 - idealValence) +
                               squared(valence - span + 2 - idealValence) +
                               squared(mesh.valence(ring[first]) + 1 - idealValence) +
                               squared(mesh.valence(ring[last]) + 1 - idealValence);
            const std::pair<int, int> cost{spread, std::abs(before - after)};
            if (cost < least) {
                least = cost;
                best = {v, first, last};
            }
        }
    return best;
}

StarSplit bestRaisingSplit(const NeuralMesh &mesh, VertexId v)
{
    StarSplit best;
    int most = 0;
    for (const VertexId u : mesh.ring(v)) {
        const int valence = mesh.valence(u);
        const int place = mesh.ring(u).find(v);
        // A new vertex and an old one of valence 4 at the least.
        for (int span = 2; span + 2 <= valence; ++span)
            for (const StarSplit &split : {StarSplit{u, place, (place + span) % valence},
                                           StarSplit{u, (place + valence - span) % valence, place}})
                if (const int gain = gainOfSplit(mesh, split); gain > most) {
                    most = gain;
                    best = split;
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
