// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth.h"

#include <algorithm>
#include <vector>

#include "growing_network.h"
#include "mesh_checks.h"
#include "morton_order.h"
#include "ring_topology.h"
#include "starting_mesh.h"

namespace neuralmesh {
namespace {

/// Signals of a batch for each vertex of the network. Larger batches keep more of the network in
/// cache, smaller ones let counters steer each split sooner.
constexpr double batchPerVertex = 0.5;

/// Samples from which the starting tetrahedron takes its place and shape.
constexpr std::size_t startingSamples = 1000;

/// Signals between two calls of the progress callback.
constexpr std::size_t signalsPerReport = 10000;

/// Growth has come to a stop where it gains less than this share of its vertices...
constexpr double leastGain = 0.05;
/// ...in this many times μ·n signals, in which it would double without collapses (at the paper's
/// constants, n·μ·5/λ = n splits).
constexpr int stagnationPeriods = 5;

class Growth {
public:
    Growth(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
           Random &random, const Progress &progress)
        : parameters_(parameters), sampler_(sampler), progress_(progress), random_(random),
          network_(mesh, sampler.bounds(), parameters), order_(sampler.bounds())
    {
    }

    GrowthReport run()
    {
        while (network_.vertexCount() < parameters_.targetVertexCount && !hasStagnated()) {
            sampleBatch();
            for (std::size_t i = 0; i < batch_.size(); ++i) {
                const VertexId winner = network_.findWinner(batch_[i]);
                network_.adapt(winner, batch_[i]);
                network_.countSignal(winner);
                if (i % signalsPerReport == 0)
                    reportProgress();
            }
            splitMostActive(batch_.size() / static_cast<std::size_t>(parameters_.signalsPerSplit));
            if (network_.collapseIsDue())
                collapseInactive();
        }
        report_.signalCount = network_.signals();
        report_.reachedTarget = network_.vertexCount() == parameters_.targetVertexCount;
        return report_;
    }

private:
    void sampleBatch()
    {
        const double splits = batchPerVertex * network_.vertexCount() / parameters_.signalsPerSplit;
        const auto signals = static_cast<std::size_t>(std::max(1.0, splits)) *
                             static_cast<std::size_t>(parameters_.signalsPerSplit);
        sampler_.draw(random_, signals, batch_);
        order_.sort(batch_);
    }

    void splitMostActive(std::size_t times)
    {
        for (std::size_t i = 0; i < times; ++i) {
            if (network_.vertexCount() == parameters_.targetVertexCount)
                return;
            network_.splitMostActive();
            ++report_.splitCount;
        }
    }

    void collapseInactive()
    {
        report_.collapseCount += static_cast<std::uint64_t>(network_.collapseInactive());
    }

    bool hasStagnated()
    {
        const int count = network_.vertexCount();
        if (count >= countAtCheck_ * (1 + leastGain)) {
            countAtCheck_ = count;
            signalsAtCheck_ = network_.signals();
        }
        const std::uint64_t period = network_.inactivityWindow();
        const auto nominal = static_cast<std::uint64_t>(countAtCheck_ * leastGain + 1) *
                             static_cast<std::uint64_t>(parameters_.signalsPerSplit);
        return network_.signals() - signalsAtCheck_ > stagnationPeriods * period + 2 * nominal;
    }

    void reportProgress()
    {
        // Each split takes λ signals, so the share of the vertices is the share of the work.
        report(progress_,
               static_cast<double>(network_.vertexCount()) / parameters_.targetVertexCount,
               "Growing the network");
    }

    const GrowthParameters &parameters_;
    const Sampler &sampler_;
    const Progress &progress_;
    Random &random_;
    GrowingNetwork network_;
    MortonOrder order_;
    std::vector<Point3> batch_;
    GrowthReport report_;
    double countAtCheck_ = 0;
    std::uint64_t signalsAtCheck_ = 0;
};

void requireEnoughPoints(const Sampler &sampler, int target)
{
    const auto wanted = static_cast<std::size_t>(target);
    const std::size_t distinct = sampler.countDistinctPoints(wanted);
    if (distinct < wanted)
        throw InvalidInput("TargetVertNum is " + std::to_string(target) +
                           ", but the input has only " + std::to_string(distinct) +
                           " distinct points: at most " + std::to_string(distinct) +
                           " vertices are possible.");
}

} // namespace

GrowthReport grow(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
                  const Progress &progress)
{
    parameters.validate();
    requireEnoughPoints(sampler, parameters.targetVertexCount);
    Random random(parameters.seed);
    std::vector<Point3> samples;
    sampler.draw(random, startingSamples, samples);
    makeTetrahedronIn(mesh, samples);
    const GrowthReport report = Growth(mesh, sampler, parameters, random, progress).run();
    if (signedVolume(mesh) < 0)
        reverseOrientation(mesh);
    rebuildFaces(mesh);
    return report;
}

} // namespace neuralmesh
