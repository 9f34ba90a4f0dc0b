// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/growth.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/closing.h"
#include "core/fit/few_points.h"
#include "core/fit/surface_fit.h"
#include "core/mesh/boundary.h"
#include "core/mesh/edge_lengths.h"
#include "core/mesh/outward.h"
#include "core/mesh/ring_topology.h"
#include "core/network/census.h"
#include "core/network/growing_network.h"
#include "core/network/learning_rules.h"
#include "core/network/stagnation.h"
#include "core/random_streams.h"
#include "core/result/convergence.h"
#include "core/result/measurement.h"
#include "core/shape/quadric_decimation.h"
#include "core/space/ordered_samples.h"
#include "core/space/plain_points.h"
#include "core/space/point_spacing.h"
#include "core/start.h"

namespace neuralmesh {
namespace {

/// Samples of a batch for each vertex of the network.
constexpr double batchPerVertex = 2;

/// One by one: larger batches keep more in cache, smaller ones let counters steer splits sooner.
constexpr double batchPerVertexOneByOne = 0.5;

/// Share of λ with which a closed start from the data settles: its vertices are near the samples.
/// The border of an open one is not.
constexpr double shareOfSettling = 0.25;

/// A vertex on the border of the data learns from samples up to so many mean edges away. The start
/// would hold what is further; vertices that follow a few strays stretch a flap to them.
constexpr Scalar reachOfBorder = 2;

/// Share of the time until growth ends; the fit takes the rest.
constexpr double shareOfGrowth = 0.85;

/// Signals between two calls of the progress callback.
constexpr std::size_t signalsPerReport = 10000;

/// Rounds of consolidation, even where each still removes a vertex. A network that learns from
/// batches has one, and then some batches in which its latest vertices find their places.
constexpr int consolidationRounds = 10;
constexpr int closingBatches = 4;

class Growth {
public:
    Growth(NeuralMesh &mesh, LearnedShape shape, const Sampler &sampler,
           const GrowthParameters &parameters, Random &random, const NetworkTaker &takeSnapshot,
           Workers &workers)
        : parameters_(parameters), shape_(shape),
          hasBorders_(shape == LearnedShape::found && !isClosed(mesh)), sampler_(sampler),
          watch_(workers.watch()), takeSnapshot_(takeSnapshot), random_(random),
          measuring_(randomStream(parameters.seed, Purpose::measuring)),
          convergence_(sampler, measuring_),
          network_(mesh, toVcg(sampler.bounds()), parameters, &workers),
          closing_(network_, parameters.targetVertexCount), batch_(sampler, watch_)
    {
        report_.changes.shape = shape;
        network_.setLimbsAreWhole(shape == LearnedShape::found);
    }

    /// Lets a starting mesh that has a shape take its place: λ signals for each vertex, as many as
    /// those of a grown network have had; fewer for a closed one that was made of the samples.
    void settle()
    {
        convergence_.noteStart(network_.mesh(), parameters_);
        growCoarseSnapshots();
        takeSnapshotIfDue();
        const bool isNearSamples = learnsBoundaries() && !hasBorders_;
        const double perVertex =
            parameters_.signalsPerSplit * (isNearSamples ? shareOfSettling : 1);
        while (static_cast<double>(network_.signals()) < perVertex * network_.vertexCount()) {
            learnBatch();
            if (network_.collapseIsDue())
                collapseInactive();
        }
    }

    GrowthReport run()
    {
        whileThereIsTime(TimeUp::inGrowth, [&] {
            takeSnapshotIfDue();
            closeHolesInData();
            if (isToBeClosed())
                closing_.judgeSheets();
            growToTarget();
            consolidate();
            closeHolesInData();
            closing_.settleCount();
        });
        report_.splitCount = network_.verticesAdded();
        report_.collapseCount = network_.verticesRemoved();
        if (parameters_.surfaceFit)
            whileThereIsTime(TimeUp::inSurfaceFit, [&] { report_.selfIntersections = fit(); });
        close();
        if (!isSnapshot_)
            measure();
        report_.convergence = convergence_.errors();
        report_.signalCount = network_.signals();
        report_.reachedTarget = isComplete() && !isTimeUp();
        report_.keptIdle = isCrowded_;
        report_.changes.websRemoved = network_.websRemoved();
        report_.changes.holesFilled += closing_.holesFilled();
        report_.changes.sheetsDoubled = closing_.sheetsDoubled();
        return report_;
    }

    /// Where time is up before these steps are done, the mesh is what they left; once it is, none
    /// is taken any more.
    template <class Steps> void whileThereIsTime(TimeUp where, const Steps &steps)
    {
        if (isTimeUp())
            return;
        try {
            watch_.look();
            steps();
        } catch (const TimeIsUp &) {
            if (isSnapshot_) // which is not finished, so it is none
                throw;
            report_.timeUp = where;
            closing_.endHere();
            watch_.mindTime(false);
        }
    }

private:
    /// All that is left to do for a sound mesh.
    void close()
    {
        watch_.mindTime(false);
        const bool isMoved = bringNearBounds(network_, sampler_, parameters_.startMesh);
        if (isToBeClosed() && !isClosed(network_.mesh()))
            report_.selfIntersections = closing_.close();
        else if (isMoved || !parameters_.surfaceFit || isTimeUp())
            report_.selfIntersections = network_.findSelfIntersections().faces;
        watch_.mindTime(!isTimeUp());
    }

    void measure()
    {
        const Measurement found = neuralmesh::measure(network_, sampler_, measuring_, isTimeUp());
        report_.rmsError = found.error.rms;
        report_.maxError = found.error.largest;
        report_.coverage = found.support.coverage;
        report_.unsupportedArea = found.support.unsupportedArea;
    }

    /// Whether boundaries are those of the data, not those of a starting mesh that was given.
    bool learnsBoundaries() const { return shape_ == LearnedShape::found; }
    bool isToBeClosed() const
    {
        return learnsBoundaries() && parameters_.boundaries == BoundaryRule::closed;
    }

    bool isTimeUp() const { return report_.timeUp != TimeUp::no; }
    bool isComplete() const { return closing_.room() <= 0; }

    void closeHolesInData()
    {
        if (learnsBoundaries())
            report_.changes.holesFilled += network_.closeHoles(parameters_.maxHoleSize);
    }

    void growToTarget()
    {
        Stagnation stagnation(network_, parameters_.signalsPerSplit, parameters_.targetVertexCount);
        while (!isComplete()) {
            learnBatch();
            splitMostActive(batch_.last().size() /
                            static_cast<std::size_t>(network_.signalsPerSplit()));
            isCrowded_ = isCrowded_ || stagnation.isReached();
            if (!isCrowded_ && network_.collapseIsDue())
                collapseInactive();
        }
    }

    /// Removes the vertices that win none of the samples of a census, where these are more than by
    /// chance, and grows again what was lost. Growth removes a vertex only after μ·n signals, in
    /// which the network grows by an eighth: the latest misplaced vertices are still there.
    void consolidate()
    {
        const bool byBatches = network_.learnsByBatches();
        const int rounds = byBatches ? 1 : consolidationRounds;
        for (int round = 0; round < rounds && !isCrowded_; ++round) {
            const Census census(network_.vertexCount(), sampler_.pointCount());
            drawBatch(census.samples());
            network_.collapse(census.misplaced(network_, batch_.last()), supportOfBatch());
            if (isComplete())
                break;
            growToTarget();
        }
        for (int batch = 0; byBatches && batch < closingBatches; ++batch)
            learnBatch();
    }

    /// Returns how many faces intersect another.
    int fit()
    {
        return fitSurface(network_, sampler_, random_, [&](double fraction, const char *activity) {
            if (isSnapshot_)
                watch_.look();
            else
                watch_.report(shareOfGrowth + (1 - shareOfGrowth) * fraction, activity);
            return true;
        });
    }

    /// Steps 1 to 4 for a batch.
    void learnBatch()
    {
        const std::vector<Point3> &batch = sampleBatch();
        reportProgress();
        if (network_.learnsByBatches())
            network_.learn(batch, reachOfBorders());
        else
            learnOneByOne(batch);
    }

    /// Steps 2 to 4 for one sample after the other, as in the paper.
    void learnOneByOne(const std::vector<Point3> &batch)
    {
        const Scalar reach = reachOfBorders();
        VertexId winner = noVertex;
        for (std::size_t i = 0; i < batch.size(); ++i) {
            winner = network_.findWinner(batch[i], winner);
            if (isBeyondBorder(network_.mesh(), winner, batch[i], reach)) {
                network_.passSignal();
            } else {
                network_.adapt(winner, batch[i]);
                network_.countSignal(winner, batch[i]);
            }
            if (i % signalsPerReport == 0)
                reportProgress();
        }
    }

    /// How far beyond a border samples are learned from.
    Scalar reachOfBorders() const
    {
        return hasBorders_ ? reachOfBorder * meanEdge(network_.mesh())
                           : std::numeric_limits<Scalar>::max();
    }

    const std::vector<Point3> &sampleBatch()
    {
        const int lambda = network_.signalsPerSplit();
        const double perVertex =
            network_.learnsByBatches() ? batchPerVertex : batchPerVertexOneByOne;
        const double splits = perVertex * network_.vertexCount() / lambda;
        return drawBatch(static_cast<std::size_t>(std::max(1.0, splits)) *
                         static_cast<std::size_t>(lambda));
    }

    /// Step 1, for a whole batch.
    const std::vector<Point3> &drawBatch(std::size_t count)
    {
        return network_.learnsByBatches() ? batch_.drawStratified(random_, count)
                                          : batch_.draw(random_, count);
    }

    void splitMostActive(std::size_t times)
    {
        int left = closing_.room();
        for (std::size_t i = 0; i < times && left > 0; ++i) {
            left -= closing_.addVertex(left);
            convergence_.note(network_);
            takeSnapshotIfDue();
        }
    }

    bool snapshotIsLeft() const
    {
        return takeSnapshot_ && snapshotsTaken_ < parameters_.snapshots.size();
    }
    int nextSnapshot() const { return parameters_.snapshots[snapshotsTaken_]; }

    void takeSnapshotIfDue()
    {
        if (!snapshotIsLeft() || closing_.vertexCount() < nextSnapshot() - closing_.mostOver())
            return;
        const int count = nextSnapshot();
        ++snapshotsTaken_;
        auto snapshot = std::make_unique<NeuralMesh>();
        snapshot->copyNetwork(network_.mesh());
        if (parameters_.surfaceFit || isToBeClosed())
            growSnapshot(*snapshot, count, false);
        makeOutwardFaces(*snapshot);
        takeSnapshot_(std::move(snapshot));
    }

    /// Those of fewer vertices than the start: each grows from a coarser one.
    void growCoarseSnapshots()
    {
        while (snapshotIsLeft() && nextSnapshot() < network_.vertexCount()) {
            const int count = nextSnapshot();
            ++snapshotsTaken_;
            auto snapshot = std::make_unique<NeuralMesh>();
            snapshot->copyNetwork(network_.mesh());
            decimate(*snapshot, count / 2);
            requireAtLeast(Parameter::snapshots, count, snapshot->vn);
            growSnapshot(*snapshot, count, true);
            makeOutwardFaces(*snapshot);
            takeSnapshot_(std::move(snapshot));
        }
    }

    /// Finishes the snapshot as a result of so many vertices, perhaps from a start. Its random
    /// numbers are its own.
    void growSnapshot(NeuralMesh &snapshot, int count, bool isStart)
    {
        GrowthParameters parameters = parameters_;
        parameters.targetVertexCount = count;
        parameters.snapshots.clear();
        Random random = randomStream(parameters_.seed, Purpose::snapshot, snapshotsTaken_);
        const NetworkTaker none;
        Growth growth(snapshot, shape_, sampler_, parameters, random, none, network_.workers());
        growth.isSnapshot_ = true;
        if (isStart)
            growth.settle();
        growth.run();
    }

    void collapseInactive()
    {
        const int perVertex = LearningRules::of(parameters_.splitRule).supportPerVertex;
        drawBatch(static_cast<std::size_t>(perVertex) *
                  static_cast<std::size_t>(network_.vertexCount()));
        network_.collapseInactive(supportOfBatch());
    }

    SampleSupport supportOfBatch() const
    {
        return {toVcg(sampler_.bounds()), batch_.last(),
                wideningForFewPoints(sampler_.pointCount(), network_.vertexCount()), watch_};
    }

    void reportProgress()
    {
        if (isSnapshot_) // the network's own work is as far as it was
            return watch_.look();
        // Each split takes λ signals, so the share of the vertices is the share of the work.
        const double start = shape_ == LearnedShape::notAsked ? 0 : shareOfStart;
        watch_.report(start + (shareOfGrowth - start) * network_.vertexCount() /
                                  parameters_.targetVertexCount,
                      "Growing the network");
    }

    const GrowthParameters &parameters_;
    LearnedShape shape_;
    bool hasBorders_; ///< of the data
    const Sampler &sampler_;
    Watch &watch_;
    const NetworkTaker &takeSnapshot_;
    Random &random_;
    Random measuring_; ///< of its own, so that measuring changes nothing
    Convergence convergence_;
    GrowingNetwork network_;
    Closing closing_;
    OrderedSamples batch_;
    GrowthReport report_;
    std::size_t snapshotsTaken_ = 0;
    bool isSnapshot_ = false; ///< of another network
    /// Whether growth gets nowhere, as for want of points. Then idle vertices are kept.
    bool isCrowded_ = false;
};

} // namespace

GrowthReport grow(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
                  const Progress &progress, const NetworkTaker &takeSnapshot)
{
    parameters.validate();
    if (!progress.isTimeUp()) // or perhaps not all points were read
        requireEnoughPoints(sampler, parameters.targetVertexCount);
    Workers workers(parameters.threads, Watch(progress));
    Random random = randomStream(parameters.seed, Purpose::growth);
    const Start start = makeStart(mesh, sampler, parameters, random, workers);
    Growth growth(mesh, start.shape, sampler, parameters, random, takeSnapshot, workers);
    if (start.hasShape)
        growth.whileThereIsTime(TimeUp::inGrowth, [&] { growth.settle(); });
    GrowthReport report = growth.run();
    report.changes.isShapeClear = start.isShapeClear;
    report.changes.gaps = start.gaps;
    makeOutwardFaces(mesh);
    return report;
}

} // namespace neuralmesh
