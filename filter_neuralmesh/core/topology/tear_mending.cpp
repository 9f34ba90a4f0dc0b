// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/tear_mending.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
#include "core/topology/filling_cost.h"
#include "core/topology/handle_loop.h"
#include "core/topology/stump_bridge.h"

namespace neuralmesh {
namespace {

/// The smallest stump, in faces, and the longest rim of one, for time.
constexpr std::size_t leastFaces = 3;
constexpr std::size_t longestRim = 150;
/// Of what the bridge gains, the two ends of the cut may cost so much.
constexpr double mostCostOfCut = 0.5;
/// Bridges tried, the best first.
constexpr std::size_t mostTried = 4;
/// Roots from which loops around handles are sought, and the longest loop that is cut.
constexpr std::size_t mostRoots = 48;
constexpr std::size_t longestLoop = 60;

/// Two stumps and the bridge between them.
struct Pair {
    std::size_t first, second;
    Bridge bridge;
};

struct Cut {
    std::vector<VertexId> loop;
    std::vector<LoopTriangle> cap;
    double cost = std::numeric_limits<double>::infinity();
};

/// What a bridge changes, to take it back.
class RingBackup {
public:
    RingBackup(const NeuralMesh &mesh, const Patch &first, const Patch &second)
    {
        for (const Patch *patch : {&first, &second})
            for (const std::vector<VertexId> *vertices : {&patch->rim, &patch->interior})
                for (const VertexId v : *vertices)
                    rings_.emplace_back(v, mesh.ring(v));
    }

    void restore(NeuralMesh &mesh) const
    {
        for (const auto &[v, ring] : rings_)
            mesh.ring(v) = ring;
    }

private:
    std::vector<std::pair<VertexId, NeighbourRing>> rings_;
};

class TearMending {
public:
    TearMending(NeuralMesh &mesh, const SampleSupport &support, int mostVertices)
        : mesh_(mesh), support_(support), mostVertices_(mostVertices),
          components_(labelComponents(mesh))
    {
    }

    bool run()
    {
        const FaceTable faces(mesh_);
        findStumps(faces);
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < stumps_.size(); ++i)
            for (std::size_t j = i + 1; j < stumps_.size(); ++j)
                if (mayFace(stumps_[i], stumps_[j]))
                    if (std::optional<Bridge> bridge =
                            betterBridge(mesh_, support_, stumps_[i], stumps_[j]))
                        pairs.push_back({i, j, std::move(*bridge)});
        std::stable_sort(pairs.begin(), pairs.end(), [](const Pair &a, const Pair &b) {
            return a.bridge.gain > b.bridge.gain;
        });
        for (std::size_t i = 0; i < pairs.size() && i < mostTried; ++i)
            if (mend(pairs[i]))
                return true;
        return false;
    }

private:
    void findStumps(const FaceTable &faces)
    {
        PatchSearch search(mesh_, faces, support_);
        for (FaceId face = 0; face < faces.size(); ++face) {
            if (!search.isSeed(face))
                continue;
            std::optional<Patch> patch = search.find(face, PatchExtent::core);
            if (patch && patch->faces.size() >= leastFaces && patch->rim.size() <= longestRim)
                stumps_.emplace_back(mesh_, faces, support_, std::move(*patch));
        }
    }

    /// Whether the two are of one component, near enough and apart from each other.
    bool mayFace(const Stump &a, const Stump &b) const
    {
        if (components_[a.patch.rim.front()] != components_[b.patch.rim.front()])
            return false;
        Box3 wide = a.bounds;
        wide.Offset(std::min(a.bounds.Diag(), b.bounds.Diag()) / 2);
        if (!wide.Collide(b.bounds))
            return false;
        const auto isShared = [&](VertexId v) {
            return std::find(b.patch.rim.begin(), b.patch.rim.end(), v) != b.patch.rim.end();
        };
        return std::none_of(a.patch.rim.begin(), a.patch.rim.end(), isShared);
    }

    bool mend(const Pair &pair)
    {
        const Patch &first = stumps_[pair.first].patch;
        const Patch &second = stumps_[pair.second].patch;
        const RingBackup backup(mesh_, first, second);
        bridgeDiscs(mesh_, first.rim, second.rim, pair.bridge.rungs);
        for (const Patch *patch : {&first, &second})
            for (const VertexId v : patch->interior)
                mesh_.ring(v).clear();
        const Cut cut = cheapestCut(first.rim.front());
        const auto vertices = mesh_.vn + static_cast<int>(cut.loop.size()) -
                              static_cast<int>(first.interior.size() + second.interior.size());
        if (!(cut.cost < mostCostOfCut * pair.bridge.gain) || vertices > mostVertices_) {
            backup.restore(mesh_);
            return false;
        }
        for (const Patch *patch : {&first, &second})
            for (const VertexId v : patch->interior)
                mesh_.removeVertex(v);
        refillDisc(mesh_, cutOpen(mesh_, cut.loop), {}, cut.cap);
        refillDisc(mesh_, {cut.loop.rbegin(), cut.loop.rend()}, {},
                   mirrored(cut.cap, cut.loop.size()));
        return true;
    }

    /// The same triangles for the loop walked backwards.
    static std::vector<LoopTriangle> mirrored(const std::vector<LoopTriangle> &cap,
                                              std::size_t size)
    {
        const int last = static_cast<int>(size) - 1;
        std::vector<LoopTriangle> found;
        for (const LoopTriangle &t : cap)
            found.push_back({last - t[2], last - t[1], last - t[0]});
        return found;
    }

    /// Of the loops around handles, the one whose ends cost least to close. Any such loop crosses
    /// one of those from a single root, so their vertices serve as roots in turn.
    Cut cheapestCut(VertexId start) const
    {
        const FaceTable faces(mesh_);
        std::vector<VertexId> roots;
        Cut best;
        for (const std::vector<VertexId> &loop : handleLoops(mesh_, faces, start)) {
            roots.insert(roots.end(), loop.begin(), loop.end());
            consider(loop, best);
        }
        const std::size_t stride = roots.size() / mostRoots + 1;
        for (std::size_t k = 0; k < roots.size(); k += stride)
            consider(handleLoops(mesh_, faces, roots[k]).front(), best);
        return best;
    }

    void consider(const std::vector<VertexId> &loop, Cut &best) const
    {
        if (loop.size() > longestLoop || !canCut(mesh_, loop))
            return;
        const FillingCost cost(mesh_, support_, loop);
        LoopTriangulation cap =
            cost.fill(loop, [&](VertexId v, VertexId u) { return mesh_.ring(v).contains(u); });
        if (2 * cap.weight < best.cost)
            best = {loop, std::move(cap.triangles), 2 * cap.weight};
    }

    NeuralMesh &mesh_;
    const SampleSupport &support_;
    int mostVertices_;
    std::vector<int> components_; ///< by vertex, before anything is changed
    std::vector<Stump> stumps_;
};

} // namespace

bool mendTear(NeuralMesh &mesh, const SampleSupport &support, int mostVertices)
{
    return TearMending(mesh, support, mostVertices).run();
}

} // namespace neuralmesh
