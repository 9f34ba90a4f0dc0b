// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/intersection_repair.h"

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/star_normal.h"

namespace neuralmesh {
namespace {

/// Rounds of either kind, each with a search for intersections, which are few after the first.
constexpr int roundsOfRestoring = 10;
constexpr int roundsOfSmoothing = 20;
/// Times a vertex is moved alone, before its neighbours are moved with it.
constexpr int timesAlone = 4;

class IntersectionRepair {
public:
    explicit IntersectionRepair(GrowingNetwork &network)
        : network_(network), mesh_(network.mesh()), moved_(mesh_)
    {
    }

    int restore(const VertexData<Point3> &before)
    {
        return repeatForIntersections(roundsOfRestoring, [&](VertexId v) {
            network_.moveVertex(v, moved_[v] + 1 < timesAlone ? (mesh_.position(v) + before[v]) / 2
                                                              : before[v]);
        });
    }

    int smooth()
    {
        return repeatForIntersections(roundsOfSmoothing, [&](VertexId v) { moveToMiddle(v); });
    }

    void unfold(const std::vector<VertexId> &sheet)
    {
        repeat(
            roundsOfSmoothing,
            [&] {
                std::vector<VertexId> folded;
                for (const VertexId v : sheet)
                    if (isFolded(mesh_, v))
                        folded.push_back(v);
                return folded;
            },
            [&](VertexId v) { moveToMiddle(v); });
    }

private:
    /// Moves the corners of faces that intersect another. Returns how many such faces are left.
    template <class Move> int repeatForIntersections(int rounds, Move move)
    {
        int left = 0;
        repeat(
            rounds,
            [&] {
                const SelfIntersections found = network_.findSelfIntersections();
                left = found.faces;
                return found.corners;
            },
            move);
        return left;
    }

    /// Moves what is found, and what is found too often with its neighbours.
    template <class Find, class Move> void repeat(int rounds, Find find, Move move)
    {
        moved_.reset();
        for (int round = 0;; ++round) {
            watch().look();
            const std::vector<VertexId> found = find();
            if (found.empty() || round == rounds || watch().isTimeUp())
                return;
            for (const VertexId v : found) {
                move(v);
                if (++moved_[v] > timesAlone)
                    for (const VertexId u : mesh_.ring(v))
                        move(u);
            }
        }
    }

    const Watch &watch() const { return network_.workers().watch(); }

    void moveToMiddle(VertexId v)
    {
        network_.moveVertex(v, (mesh_.position(v) + middleOfNeighbours(v)) / 2);
    }

    /// On a boundary, of those along it.
    Point3 middleOfNeighbours(VertexId v) const
    {
        if (mesh_.isOnBoundary(v))
            return (mesh_.position(previousOnBoundary(mesh_, v)) +
                    mesh_.position(nextOnBoundary(mesh_, v))) /
                   2;
        Point3 sum(0, 0, 0);
        for (const VertexId u : mesh_.ring(v))
            sum += mesh_.position(u);
        return sum / mesh_.valence(v);
    }

    GrowingNetwork &network_;
    const NeuralMesh &mesh_;
    VertexData<int> moved_; ///< how often
};

} // namespace

int repairIntersections(GrowingNetwork &network, const VertexData<Point3> &before)
{
    IntersectionRepair repair(network);
    const int left = repair.restore(before);
    return left == 0 || network.workers().watch().isTimeUp() ? left : repair.smooth();
}

void unfold(GrowingNetwork &network, const std::vector<VertexId> &sheet)
{
    IntersectionRepair(network).unfold(sheet);
}

int smoothIntersections(GrowingNetwork &network)
{
    return IntersectionRepair(network).smooth();
}

} // namespace neuralmesh
