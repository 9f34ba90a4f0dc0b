// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/batch_learning.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/boundary.h"
#include "core/network/signal_activity.h"
#include "core/nth_root.h"
#include "core/parallel/vertex_loops.h"

namespace neuralmesh {
namespace {

/// A vertex is smoothed half-way at the most: its neighbours move at the same time, and where all
/// go further, they pass each other. By 0.8, a sheet folds at its border.
constexpr double mostSmoothing = 0.5;

/// Steps beyond so many are as good as infinitely many.
constexpr int manySteps = 256;

/// What is left of the way after k steps that go a share of it each, for k below manySteps.
std::vector<double> remainders(double share, int stepsAtOnce)
{
    std::vector<double> left;
    left.reserve(manySteps);
    const double afterOne = power(1 - share, static_cast<std::size_t>(stepsAtOnce));
    for (double value = 1; left.size() < manySteps; value *= afterOne)
        left.push_back(value);
    return left;
}

double gone(const std::vector<double> &left, int steps)
{
    return 1 - left[static_cast<std::size_t>(std::min(steps, manySteps - 1))];
}

} // namespace

BatchLearning::Signal BatchLearning::signal(const SampleLocator &locator, VertexId nearest,
                                            const Point3 &sample, const BatchRules &rules) const
{
    const StarProjection p = locator.project(nearest, sample);
    const VertexId winner = winnerOf(mesh_, nearest, p);
    if (isBeyondBorder(mesh_, winner, sample, rules.reachOfBorder))
        return {noVertex, 0};
    return {winner, std::sqrt(residualFromSurface(mesh_, p).Norm())};
}

/// Of the samples that count.
Scalar BatchLearning::meanRoughness() const
{
    Scalar sum = 0;
    std::size_t count = 0;
    for (const Signal &signal : signals_)
        if (signal.winner != noVertex) {
            sum += signal.roughness;
            ++count;
        }
    return count > 0 ? sum / static_cast<Scalar>(count) : 0;
}

const std::vector<Wins> &BatchLearning::win(const std::vector<Point3> &samples,
                                            const BatchRules &rules)
{
    const SampleLocator locator(mesh_, bounds_, workers_);
    signals_.resize(samples.size());
    locator.forEachNearest(workers_, samples, [&](std::size_t i, VertexId nearest) {
        signals_[i] = signal(locator, nearest, samples[i], rules);
    });
    // While all samples lie on the surface, the distance says nothing.
    const Scalar mean = rules.countsByDistance ? meanRoughness() : 0;
    wins_.assign(mesh_.idBound(), {});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (signals_[i].winner == noVertex)
            continue;
        Wins &wins = wins_[signals_[i].winner];
        ++wins.signals;
        wins.activity += mean > 0 ? SignalActivity::ofRelative(signals_[i].roughness / mean) : 1;
        wins.pull += samples[i] - mesh_.position(signals_[i].winner);
    }
    return wins_;
}

Point3 BatchLearning::pulled(VertexId v, const std::vector<double> &left) const
{
    const Wins &wins = wins_[v];
    return wins.signals > 0
               ? mesh_.position(v) + wins.pull * (gone(left, wins.signals) / wins.signals)
               : mesh_.position(v);
}

Point3 BatchLearning::smoothed(VertexId v, const std::vector<double> &left) const
{
    const NeighbourRing &ring = mesh_.ring(v);
    const Point3 &centre = pulled_[v];
    int signals = 0;
    for (const VertexId u : ring)
        signals += wins_[u].signals;
    if (signals == 0)
        return centre;
    const Scalar share = std::min(mostSmoothing, gone(left, signals));
    if (mesh_.isOnBoundary(v)) {
        const Point3 &next = pulled_[nextOnBoundary(mesh_, v)];
        const Point3 &previous = pulled_[previousOnBoundary(mesh_, v)];
        const Point3 axis = (next - previous).Normalize();
        return centre + axis * (((next + previous) / 2 - centre) * axis * share);
    }
    Point3 normal(0, 0, 0);
    Point3 laplacian(0, 0, 0);
    Point3 before = pulled_[ring[ring.size() - 1]] - centre;
    for (const VertexId u : ring) {
        const Point3 edge = pulled_[u] - centre;
        normal += before ^ edge;
        laplacian += edge;
        before = edge;
    }
    laplacian /= static_cast<Scalar>(ring.size()); // equation 3
    const Scalar squared = normal.SquaredNorm();
    if (squared > 0)
        laplacian -= normal * (laplacian * normal / squared); // 4
    return centre + laplacian * share;                        // 5
}

const std::vector<Point3> &BatchLearning::move(const GrowthParameters &parameters)
{
    pulled_.resize(mesh_.idBound());
    moved_.resize(mesh_.idBound());
    const std::vector<double> pullLeft = remainders(parameters.winnerRate, 1);
    forEachVertex(workers_, mesh_, [&](VertexId v) { pulled_[v] = pulled(v, pullLeft); });
    const std::vector<double> smoothingLeft =
        remainders(parameters.smoothingRate, parameters.smoothingPasses);
    forEachVertex(workers_, mesh_, [&](VertexId v) { moved_[v] = smoothed(v, smoothingLeft); });
    return moved_;
}

} // namespace neuralmesh
