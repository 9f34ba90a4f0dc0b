// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/intersection_repair.h"

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"

namespace neuralmesh {
namespace {

/// Rounds of either kind, each with a search for intersections, which are few after the first.
constexpr int roundsOfRestoring = 10;
constexpr int roundsOfSmoothing = 20;
/// Times a vertex is moved alone, before its neighbours are moved with it.
constexpr int timesAlone = 4;

class IntersectionRepair {
public:
    IntersectionRepair(GrowingNetwork &network, const RimNeighbours &rim)
        : network_(network), mesh_(network.mesh()), rim_(rim), moved_(mesh_)
    {
    }

    int restore(const VertexData<Point3> &before)
    {
        return repeat(roundsOfRestoring, [&](VertexId v) {
            network_.moveVertex(v, moved_[v] + 1 < timesAlone ? (mesh_.position(v) + before[v]) / 2
                                                              : before[v]);
        });
    }

    int smooth()
    {
        return repeat(roundsOfSmoothing, [&](VertexId v) {
            network_.moveVertex(v, (mesh_.position(v) + middleOfNeighbours(v)) / 2);
        });
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

    /// On the rim, of those along it.
    Point3 middleOfNeighbours(VertexId v) const
    {
        if (rim_.isOnRim(v))
            return (mesh_.position(rim_.before(v)) + mesh_.position(rim_.after(v))) / 2;
        Point3 sum(0, 0, 0);
        for (const VertexId u : mesh_.ring(v))
            sum += mesh_.position(u);
        return sum / mesh_.valence(v);
    }

    GrowingNetwork &network_;
    const NeuralMesh &mesh_;
    const RimNeighbours &rim_;
    VertexData<int> moved_; ///< how often
};

} // namespace

RimNeighbours::RimNeighbours(const NeuralMesh &mesh)
    : before_(mesh, noVertex), after_(mesh, noVertex)
{
    forEachVertex(mesh, [&](VertexId v) {
        if (!mesh.isOnBoundary(v))
            return;
        before_[v] = previousOnBoundary(mesh, v);
        after_[v] = nextOnBoundary(mesh, v);
    });
}

int repairIntersections(GrowingNetwork &network, const VertexData<Point3> &before)
{
    const RimNeighbours rim(network.mesh());
    IntersectionRepair repair(network, rim);
    return repair.restore(before) == 0 ? 0 : repair.smooth();
}

int repairClosing(GrowingNetwork &network, const RimNeighbours &rim)
{
    return IntersectionRepair(network, rim).smooth();
}

} // namespace neuralmesh
