// SPDX-License-Identifier: GPL-3.0-or-later
#include "tear_mending.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "annulus_triangulation.h"
#include "filling_cost.h"
#include "handle_loop.h"
#include "mesh_checks.h"
#include "ring_surgery.h"
#include "ring_topology.h"
#include "unsupported_patches.h"

namespace neuralmesh {
namespace {

/// The smallest stump, in faces, and the longest rim of one, for time.
constexpr std::size_t leastFaces = 3;
constexpr std::size_t longestRim = 150;
/// Band and samples must come so much nearer to each other than the stumps were, in squared
/// distance.
constexpr double leastGain = 0.5;
/// Of what the bridge gains, the two ends of the cut may cost so much.
constexpr double mostCostOfCut = 0.5;
/// Bridges tried, the best first.
constexpr std::size_t mostTried = 4;
/// Roots from which loops around handles are sought, and the longest loop that is cut.
constexpr std::size_t mostRoots = 48;
constexpr std::size_t longestLoop = 60;

struct Bridge {
    std::size_t first, second; ///< patches
    std::vector<std::pair<int, int>> rungs;
    double gain;
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
    TearMending(NeuralMesh &mesh, const SampleSupport &support, int mostVertices,
                std::vector<VertexId> &freeSlots)
        : mesh_(mesh), support_(support), mostVertices_(mostVertices), freeSlots_(freeSlots),
          components_(labelComponents(mesh))
    {
    }

    std::optional<TearChanges> run()
    {
        const FaceTable faces(mesh_);
        findPatches(faces);
        std::vector<Bridge> bridges;
        for (std::size_t i = 0; i < patches_.size(); ++i)
            for (std::size_t j = i + 1; j < patches_.size(); ++j)
                if (mayFace(i, j))
                    if (std::optional<Bridge> bridge = betterBridge(faces, i, j))
                        bridges.push_back(std::move(*bridge));
        std::stable_sort(bridges.begin(), bridges.end(),
                         [](const Bridge &a, const Bridge &b) { return a.gain > b.gain; });
        for (std::size_t i = 0; i < bridges.size() && i < mostTried; ++i)
            if (std::optional<TearChanges> changes = mend(bridges[i]))
                return changes;
        return std::nullopt;
    }

private:
    void findPatches(const FaceTable &faces)
    {
        patches_.clear();
        bounds_.clear();
        PatchSearch search(mesh_, faces, support_);
        for (FaceId face = 0; face < faces.size(); ++face) {
            if (!search.isSeed(face))
                continue;
            std::optional<Patch> patch = search.find(face, PatchExtent::core);
            if (!patch || patch->faces.size() < leastFaces || patch->rim.size() > longestRim)
                continue;
            Box3 bounds;
            for (const VertexId v : patch->rim)
                bounds.Add(mesh_.position(v));
            bounds_.push_back(bounds);
            patches_.push_back(std::move(*patch));
        }
    }

    /// Whether the two are of one component, near enough and apart from each other.
    bool mayFace(std::size_t i, std::size_t j) const
    {
        if (components_[patches_[i].rim.front()] != components_[patches_[j].rim.front()])
            return false;
        Box3 wide = bounds_[i];
        wide.Offset(std::min(bounds_[i].Diag(), bounds_[j].Diag()) / 2);
        if (!wide.Collide(bounds_[j]))
            return false;
        const auto isShared = [&](VertexId v) {
            const std::vector<VertexId> &rim = patches_[j].rim;
            return std::find(rim.begin(), rim.end(), v) != rim.end();
        };
        return std::none_of(patches_[i].rim.begin(), patches_[i].rim.end(), isShared);
    }

    std::optional<Bridge> betterBridge(const FaceTable &faces, std::size_t i, std::size_t j) const
    {
        const std::vector<VertexId> &first = patches_[i].rim;
        const std::vector<VertexId> &second = patches_[j].rim;
        const FillingCost cost(mesh_, support_, first);
        std::vector<Corners> before;
        for (const std::size_t patch : {i, j})
            for (const FaceId face : patches_[patch].faces)
                before.push_back(faces.corners(face));
        const double weightNow = cost.weight(before);
        const AnnulusTriangulation band =
            triangulateAnnulus(static_cast<int>(first.size()), static_cast<int>(second.size()),
                               bandWeights(cost, first, second));
        if (!(band.weight < leastGain * weightNow))
            return std::nullopt;
        const FillingCost::Missed missed =
            cost.missed(before, bandFaces(first, second, band.rungs));
        const double now = weightNow + missed.before;
        const double then = band.weight + missed.after;
        if (!(then < leastGain * now))
            return std::nullopt;
        return Bridge{i, j, band.rungs, now - then};
    }

    AnnulusWeights bandWeights(const FillingCost &cost, const std::vector<VertexId> &first,
                               const std::vector<VertexId> &second) const
    {
        const std::size_t n = first.size();
        const std::size_t m = second.size();
        std::vector<double> rungs(n * m);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j)
                rungs[i * m + j] = mesh_.ring(first[i]).contains(second[j])
                                       ? std::numeric_limits<double>::infinity()
                                       : cost.squaredDistanceOfEdge(first[i], second[j]);
        const auto place = [](int i) { return static_cast<std::size_t>(i); };
        return {[=, &cost, &first, &second](int i, int j) {
                    const std::size_t next = place(i + 1) % n;
                    return cost.weight({first[place(i)], first[next], second[place(j)]},
                                       cost.squaredDistanceOfEdge(first[place(i)], first[next]),
                                       rungs[next * m + place(j)], rungs[place(i) * m + place(j)]);
                },
                [=, &cost, &first, &second](int i, int j) {
                    const std::size_t next = (place(j) + m - 1) % m;
                    return cost.weight({second[next], second[place(j)], first[place(i)]},
                                       cost.squaredDistanceOfEdge(second[next], second[place(j)]),
                                       rungs[place(i) * m + place(j)], rungs[place(i) * m + next]);
                }};
    }

    static std::vector<Corners> bandFaces(const std::vector<VertexId> &first,
                                          const std::vector<VertexId> &second,
                                          const std::vector<std::pair<int, int>> &rungs)
    {
        std::vector<Corners> faces;
        for (std::size_t k = 0; k < rungs.size(); ++k) {
            const auto &[i, j] = rungs[k];
            const auto &[nextI, nextJ] = rungs[(k + 1) % rungs.size()];
            const VertexId third = i != nextI ? first[static_cast<std::size_t>(nextI)]
                                              : second[static_cast<std::size_t>(nextJ)];
            faces.push_back(
                {first[static_cast<std::size_t>(i)], third, second[static_cast<std::size_t>(j)]});
        }
        return faces;
    }

    std::optional<TearChanges> mend(const Bridge &bridge)
    {
        const Patch &first = patches_[bridge.first];
        const Patch &second = patches_[bridge.second];
        const RingBackup backup(mesh_, first, second);
        bridgeDiscs(mesh_, first.rim, second.rim, bridge.rungs);
        for (const Patch *patch : {&first, &second})
            for (const VertexId v : patch->interior)
                mesh_.ring(v).clear();
        const Cut cut = cheapestCut(first.rim.front());
        const auto vertices = mesh_.vn + static_cast<int>(cut.loop.size()) -
                              static_cast<int>(first.interior.size() + second.interior.size());
        if (!(cut.cost < mostCostOfCut * bridge.gain) || vertices > mostVertices_) {
            backup.restore(mesh_);
            return std::nullopt;
        }
        TearChanges changes;
        for (const Patch *patch : {&first, &second})
            for (const VertexId v : patch->interior) {
                removeVertex(mesh_, v, freeSlots_);
                changes.removed.push_back(v);
            }
        changes.added = cutOpen(mesh_, cut.loop, freeSlots_);
        close(changes.added, cut.cap);
        close({cut.loop.rbegin(), cut.loop.rend()}, mirrored(cut.cap, cut.loop.size()));
        return changes;
    }

    void close(const std::vector<VertexId> &hole, const std::vector<LoopTriangle> &cap)
    {
        refillDisc(mesh_, hole, {}, cap, freeSlots_);
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
    std::vector<VertexId> &freeSlots_;
    std::vector<int> components_; ///< by vertex, before anything is changed
    std::vector<Patch> patches_;
    std::vector<Box3> bounds_; ///< of their rims
};

} // namespace

std::optional<TearChanges> mendTear(NeuralMesh &mesh, const SampleSupport &support,
                                    int mostVertices, std::vector<VertexId> &freeSlots)
{
    return TearMending(mesh, support, mostVertices, freeSlots).run();
}

} // namespace neuralmesh
