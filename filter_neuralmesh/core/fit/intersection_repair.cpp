// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/intersection_repair.h"

#include "core/mesh/boundary.h"

namespace neuralmesh {
namespace {

/// Rounds of either kind, each with a search for intersections, which are few after the first.
constexpr int roundsOfRestoring = 10;
constexpr int roundsOfSmoothing = 20;
/// Times a vertex is moved alone, before its neighbours are moved with it.
constexpr int timesAlone = 4;

class IntersectionRepair {
public:
    IntersectionRepair(GrowingNetwork &network, const VertexData<Point3> &before)
        : network_(network), mesh_(network.mesh()), before_(before), moved_(mesh_)
    {
    }

    int run()
    {
        if (repeat(roundsOfRestoring, [&](VertexId v) { restore(v); }) == 0)
            return 0;
        return repeat(roundsOfSmoothing, [&](VertexId v) { smooth(v); });
    }

private:
    /// Returns how many faces that intersect another are left.
    template <class Move> int repeat(int rounds, Move move)
    {
        moved_.reset();
        for (int round = 0;; ++round) {
            const SelfIntersections found = network_.findSelfIntersections();
            if (found.faces == 0 || round == rounds)
                return found.faces;
            for (const VertexId v : found.corners) {
                move(v);
                if (++moved_[v] > timesAlone)
                    for (const VertexId u : mesh_.ring(v))
                        move(u);
            }
        }
    }

    void restore(VertexId v)
    {
        network_.moveVertex(v, moved_[v] + 1 < timesAlone ? (mesh_.position(v) + before_[v]) / 2
                                                          : before_[v]);
    }

    void smooth(VertexId v)
    {
        network_.moveVertex(v, (mesh_.position(v) + middleOfNeighbours(v)) / 2);
    }

    /// On a boundary, of those along it.
    Point3 middleOfNeighbours(VertexId v) const
    {
        if (mesh_.isOnBoundary(v))
            return (mesh_.position(nextOnBoundary(mesh_, v)) +
                    mesh_.position(previousOnBoundary(mesh_, v))) /
                   2;
        Point3 sum(0, 0, 0);
        for (const VertexId u : mesh_.ring(v))
            sum += mesh_.position(u);
        return sum / mesh_.valence(v);
    }

    GrowingNetwork &network_;
    const NeuralMesh &mesh_;
    const VertexData<Point3> &before_;
    VertexData<int> moved_; ///< how often
};

} // namespace

int repairIntersections(GrowingNetwork &network, const VertexData<Point3> &before)
{
    return IntersectionRepair(network, before).run();
}

} // namespace neuralmesh
