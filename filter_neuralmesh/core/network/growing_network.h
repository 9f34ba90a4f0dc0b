// SPDX-License-Identifier: GPL-3.0-or-later
// The growing network: steps 2 to 6 of the paper, one public function each.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/vertex_data.h"
#include "core/network/batch_learning.h"
#include "core/network/learning_rules.h"
#include "core/network/neighbour_smoothing.h"
#include "core/network/signal_activity.h"
#include "core/network/signal_counters.h"
#include "core/network/star_projection.h"
#include "core/network/star_splits.h"
#include "core/parallel/workers.h"
#include "core/space/vertex_grid.h"
#include "core/topology/refused_patches.h"
#include "core/topology/sample_support.h"
#include "neuralmesh/parameters.h"

namespace neuralmesh {

/// The mesh, the nearest-neighbour index of its vertices and their signal counters. Index and
/// counters follow the mesh: whatever adds and removes vertices need not know of them. Only what
/// moves a vertex does, by moveVertex().
class GrowingNetwork final : private VertexFollower {
public:
    /// Starts from a closed manifold mesh in the unit frame; `bounds` are those of the samples.
    /// Without workers, the caller's thread does all.
    GrowingNetwork(NeuralMesh &startingMesh, const Box3 &bounds, const GrowthParameters &parameters,
                   Workers *workers = nullptr);
    ~GrowingNetwork() { mesh_.unfollow(*this); }
    GrowingNetwork(const GrowingNetwork &) = delete;
    GrowingNetwork &operator=(const GrowingNetwork &) = delete;

    const NeuralMesh &mesh() const { return mesh_; }
    Workers &workers() const { return workers_; }
    int vertexCount() const { return mesh_.vn; }
    /// Signals counted so far.
    std::uint64_t signals() const { return signals_; }
    /// Vertices that came so far, by splits.
    std::uint64_t verticesAdded() const { return added_; }
    /// Vertices that went so far: by collapses, and with the webs that were taken out.
    std::uint64_t verticesRemoved() const { return removed_; }

    /// Whether all limbs of the target are there, as where the network started from its shape. Then
    /// it is never young.
    void setLimbsAreWhole(bool areWhole) { limbsAreWhole_ = areWhole; }

    int websRemoved() const { return websRemoved_; }

    /// The vertex nearest to the sample. The hint, any vertex that may be near, such as the one
    /// nearest to the last sample, saves time and changes nothing.
    VertexId nearestVertex(const Point3 &sample, VertexId hint = noVertex) const;

    /// Step 2: the winner, by the rules. The hint as above.
    VertexId findWinner(const Point3 &sample, VertexId hint = noVertex) const;

    /// The point of the mesh nearest to the sample, given the vertex nearest to it.
    StarProjection project(VertexId nearest, const Point3 &sample) const;

    /// Finds the same for many samples, until a vertex moves.
    SampleLocator locator() const { return {mesh_, bounds_, workers_}; }

    /// Moves a vertex to another place.
    void moveVertex(VertexId v, const Point3 &position);

    /// Makes the mesh's faces anew.
    SelfIntersections findSelfIntersections();

    /// Fills every boundary by a disc without new vertices. Returns how many were filled.
    int closeBoundaries();

    /// Fills those only that are no wider than that, in the unit frame, seen as a circle.
    int closeHoles(double width);

    /// Closes sheets, of which these are all vertices, by sheets behind them (sheet_doubling.h),
    /// and parts the two by next to nothing.
    void closeSheets(const std::vector<VertexId> &sheets);

    /// Splits the longest edge of a boundary, of those from the vertices. Returns the new vertex,
    /// which lies on the boundary, or noVertex where there is none.
    VertexId splitBoundary(const std::vector<VertexId> &vertices);

    /// Removes a vertex so that valences come out even and the surface stays, as far as that goes.
    /// False where none can go.
    bool removeOne();

    /// Flips edges all over the mesh where that evens out the valences or widens angles.
    void evenValences();

    /// Exchanges vertices so that fewer have a valence below 5 or above 7. Those of valence 3 and 4
    /// are removed by edge collapses that keep the surface, and as many others as are needed, where
    /// that evens out valences. Instead, those of 8 or more are split, and neighbours of those of 3
    /// or 4 that must stay; then the most active. Returns the new ones; the count stays.
    std::vector<VertexId> exchangeIrregular();

    /// Step 3: moves the winner towards the sample (equation 2) and smooths its neighbours within
    /// their tangent planes (equations 3 to 5).
    void adapt(VertexId winner, const Point3 &sample);

    /// Step 4: counts the signal for the winner, by the rules, and decays all counters (equations 6
    /// and 7).
    void countSignal(VertexId winner, const Point3 &sample);

    /// A signal that nothing is learned from.
    void passSignal() { ++signals_; }

    /// Steps 2 to 4 for all samples at once. Nothing is learned from those further than `reach`
    /// from a winner on a boundary.
    void learn(const std::vector<Point3> &samples, Scalar reach);

    /// Whether the network learns from a batch at once, by the rules: once it has all limbs.
    bool learnsByBatches() const { return rules_.learnsByBatches && limbsAreWhole_; }

    /// Step 5: λ, the signals for each split, by the rules.
    int signalsPerSplit() const;

    /// Step 5: splits the vertex with the highest counter along its longest edge.
    VertexId splitMostActive();

    /// Step 6: removes every vertex that has not won in the last μ·n signals by the edge collapse
    /// with the least regularity error (equation 9). A vertex none of whose edges may collapse
    /// stays.
    void collapseInactive(const SampleSupport &support);

    /// Removes these vertices in the same way, then the webs that this leaves.
    void collapse(const std::vector<VertexId> &vertices, const SampleSupport &support);

    /// μ·n signals: a vertex that wins none of so many is inactive.
    std::uint64_t inactivityWindow() const;

    /// Whether the next collapseInactive() is due: μ·n signals after the last.
    bool collapseIsDue() const;

    /// Whether the target space was found to be an open surface, from a share of the mesh that no
    /// sample supports. Then webs are left alone: one is the sheet that closes it.
    bool isOpenSurface() const { return isOpen_; }

private:
    VertexGrid &grid() const;
    bool isYoung() const;
    VertexId splitOff(VertexId v);
    VertexId splitStar(const StarSplit &star, const Point3 &position);
    void shareCounter(VertexId v, VertexId w);
    double activity(VertexId winner, const Point3 &sample);
    bool countsByDistance() const;
    Scalar voronoiArea(VertexId v) const;
    bool isInactive(VertexId v) const;
    void judgeOpenness(const SampleSupport &support);
    void removeWebs(const SampleSupport &support);
    void vertexAdded(VertexId v) override;
    void vertexRemoved(VertexId v) override;
    void enrol(VertexId v);
    void updateDecay();

    GrowthParameters parameters_;
    LearningRules rules_;
    mutable Workers alone_; ///< where none are given
    Workers &workers_;
    NeuralMesh &mesh_;
    Box3 bounds_;
    mutable std::optional<VertexGrid> grid_; ///< made where winners are looked for one by one
    NeighbourSmoothing smoothing_;
    SignalActivity activity_;
    BatchLearning batch_;
    SignalCounters counters_;
    VertexData<std::uint64_t> lastWin_; ///< signals_ when the vertex last won or was made
    RefusedPatches refused_;
    double decayPerSignal_ = 1;
    std::uint64_t signals_ = 0;
    std::uint64_t lastCollapse_ = 0;
    std::uint64_t added_ = 0;
    std::uint64_t removed_ = 0;
    int websRemoved_ = 0;
    bool limbsAreWhole_ = false;
    bool isJudged_ = false; ///< whether isOpen_ is known
    bool isOpen_ = false;
};

} // namespace neuralmesh
