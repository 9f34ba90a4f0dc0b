// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/growing_network.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/boundary.h"
#include "core/mesh/edge_lengths.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/star_normal.h"
#include "core/network/boundary_notches.h"
#include "core/network/edge_flips.h"
#include "core/network/regular_collapses.h"
#include "core/network/valences.h"
#include "core/nth_root.h"
#include "core/topology/hole_filling.h"
#include "core/topology/sheet_doubling.h"
#include "core/topology/unsupported_edges.h"
#include "core/topology/web_removal.h"

namespace neuralmesh {
namespace {

/// The window of step 6 is that of at least so many vertices. Around the first handful, in a long
/// target, there may be vertices that win next to nothing: collapsed at once and split again, they
/// would keep the network a tetrahedron for ever.
constexpr int fewVertices = 50;

/// Vertices from which a network is no longer young: it has found the limbs of its target.
constexpr int youngVertices = 500;

/// Vertices from which whole webs are taken out. A coarser network spans everything.
constexpr int webVertices = 1000;

/// Vertices from which the network tells whether the target space is open: all limbs are found by
/// then, and webs not yet taken out.
constexpr int judgedVertices = 800;

/// Share of the mesh's area that is far from all samples, at that size, from which the target space
/// is taken for an open surface, whose closing sheet must stay. Half-way between closed models,
/// 0.00 to 0.16, and what is seen of them from one side, 0.25 to 0.44: see docs/constants.md.
constexpr double shareOfOpenSurface = 0.2;

/// Share of the target from which signals count by distance: while the network is coarse, errors
/// are those of webs and of limbs not yet found, and following them keeps the webs (dino's legs).
constexpr double countByDistanceFrom = 0.4;

/// Distance of a sheet from the one that closes it, in mean lengths of the edges: as little as
/// keeps them apart where a host computes in single precision.
constexpr Scalar thicknessOfSheets = 1e-3;

} // namespace

GrowingNetwork::GrowingNetwork(NeuralMesh &startingMesh, const Box3 &bounds,
                               const GrowthParameters &parameters, Workers *workers)
    : parameters_(parameters), rules_(LearningRules::of(parameters.splitRule)),
      workers_(workers ? *workers : alone_), mesh_(startingMesh), bounds_(bounds),
      smoothing_(parameters.smoothingRate, parameters.smoothingPasses),
      batch_(mesh_, bounds, workers_), lastWin_(startingMesh), refused_(startingMesh)
{
    forEachVertex(mesh_, [&](VertexId v) { enrol(v); });
    mesh_.follow(*this);
    updateDecay();
}

VertexGrid &GrowingNetwork::grid() const
{
    if (!grid_) {
        grid_.emplace(bounds_);
        forEachVertex(mesh_, [&](VertexId v) { grid_->insert(v, mesh_.position(v)); });
    }
    return *grid_;
}

VertexId GrowingNetwork::nearestVertex(const Point3 &sample, VertexId hint) const
{
    return grid().nearest(sample, hint);
}

VertexId GrowingNetwork::findWinner(const Point3 &sample, VertexId hint) const
{
    const VertexId nearest = nearestVertex(sample, hint);
    if (!rules_.winnerIsOnNearestSheet)
        return nearest;
    return winnerOf(mesh_, nearest,
                    isYoung() ? projectOnStar(mesh_, nearest, sample) : project(nearest, sample));
}

bool GrowingNetwork::isYoung() const
{
    return !limbsAreWhole_ && vertexCount() < youngVertices;
}

StarProjection GrowingNetwork::project(VertexId nearest, const Point3 &sample) const
{
    return projectOnSheets(mesh_, grid(), nearest, sample, reachForSheets(mesh_, nearest, sample));
}

void GrowingNetwork::moveVertex(VertexId v, const Point3 &position)
{
    mesh_.position(v) = position;
    if (grid_)
        grid_->move(v, position);
}

SelfIntersections GrowingNetwork::findSelfIntersections()
{
    return neuralmesh::findSelfIntersections(mesh_, workers_);
}

int GrowingNetwork::closeBoundaries()
{
    return fillHoles(mesh_);
}

int GrowingNetwork::closeHoles(double width)
{
    return fillHolesUpTo(mesh_, M_PI / 4 * width * width);
}

void GrowingNetwork::closeSheets(const std::vector<VertexId> &sheets)
{
    const std::vector<Doubled> doubled = doubleSheets(mesh_, sheets);
    std::vector<Point3> half;
    half.reserve(doubled.size());
    for (const auto &[front, back] : doubled)
        half.push_back(starNormal(mesh_, front) * (thicknessOfSheets / 2 * meanEdge(mesh_, front)));
    for (std::size_t i = 0; i < doubled.size(); ++i) {
        moveVertex(doubled[i].first, mesh_.position(doubled[i].first) + half[i]);
        moveVertex(doubled[i].second, mesh_.position(doubled[i].second) - half[i]);
    }
}

VertexId GrowingNetwork::splitBoundary(const std::vector<VertexId> &vertices)
{
    const VertexId v = startOfLongestBoundaryEdge(mesh_, vertices);
    if (v == noVertex)
        return noVertex;
    return splitStar(balancedSplit(mesh_, v, 0),
                     (mesh_.position(nextOnBoundary(mesh_, v)) + mesh_.position(v)) / 2);
}

bool GrowingNetwork::removeOne()
{
    const VertexCollapse least = leastVisibleCollapse(mesh_);
    if (least.vertex == noVertex)
        return false;
    neuralmesh::collapse(mesh_, least.vertex, least.into);
    return true;
}

void GrowingNetwork::evenValences()
{
    fillNotches(mesh_);
    forEachVertex(mesh_, [&](VertexId v) { evenValencesAround(mesh_, v); });
}

std::vector<VertexId> GrowingNetwork::exchangeIrregular()
{
    const auto isLow = [&](VertexId v) { return mesh_.isLive(v) && valenceExcess(mesh_, v) < -1; };
    const auto isHigh = [&](VertexId v) { return mesh_.isLive(v) && valenceExcess(mesh_, v) > 1; };
    const VertexId bound = mesh_.idBound();
    int spared = 0;
    int wanted = 0;
    const auto spare = [&](VertexId v) {
        if (const VertexId into = bestCollapseOnSurface(mesh_, v); into != noVertex) {
            neuralmesh::collapse(mesh_, v, into);
            ++spared;
        }
    };
    for (VertexId v = 0; v < bound; ++v) {
        if (isLow(v))
            spare(v);
        wanted += isLow(v) || isHigh(v) ? 1 : 0;
    }
    for (const VertexId v : mostRegularCollapses(mesh_)) {
        if (spared >= wanted)
            break;
        if (valenceExcess(mesh_, v) == -1)
            spare(v);
    }
    std::vector<VertexId> made;
    for (VertexId v = 0; v < bound && spared > 0; ++v) {
        const StarSplit star = isLow(v) ? bestRaisingSplit(mesh_, v) : StarSplit{};
        if (star.vertex != noVertex)
            made.push_back(splitStar(star, middleOfSpan(mesh_, star)));
        else if (isHigh(v))
            made.push_back(splitOff(v));
        else
            continue;
        --spared;
    }
    for (; spared > 0; --spared)
        made.push_back(splitMostActive());
    return made;
}

void GrowingNetwork::adapt(VertexId winner, const Point3 &sample)
{
    const Point3 &position = mesh_.position(winner);
    moveVertex(winner, position + (sample - position) * parameters_.winnerRate);

    const NeighbourRing &ring = mesh_.ring(winner);
    const auto &smoothed = smoothing_.smooth(mesh_, winner);
    for (int i = 0; i < ring.size(); ++i)
        moveVertex(ring[i], smoothed[static_cast<std::size_t>(i)].position);
}

void GrowingNetwork::countSignal(VertexId winner, const Point3 &sample)
{
    ++signals_;
    lastWin_[winner] = signals_;
    counters_.add(winner, activity(winner, sample));
    counters_.decay(decayPerSignal_);
}

double GrowingNetwork::activity(VertexId winner, const Point3 &sample)
{
    if (!rules_.signalsCountByDistance)
        return 1;
    const double count =
        activity_.count(residualFromSurface(mesh_, projectOnStar(mesh_, winner, sample)).Norm());
    return countsByDistance() ? count : 1;
}

bool GrowingNetwork::countsByDistance() const
{
    return vertexCount() >= countByDistanceFrom * parameters_.targetVertexCount;
}

void GrowingNetwork::learn(const std::vector<Point3> &samples, Scalar reach)
{
    const std::vector<Wins> &wins = batch_.win(samples, {countsByDistance(), reach});
    signals_ += samples.size();
    forEachVertex(mesh_, [&](VertexId v) {
        if (wins[v].signals > 0) {
            lastWin_[v] = signals_;
            counters_.add(v, wins[v].activity);
        }
    });
    counters_.decay(power(decayPerSignal_, samples.size()));
    const std::vector<Point3> &moved = batch_.move(parameters_);
    forEachVertex(mesh_, [&](VertexId v) { moveVertex(v, moved[v]); });
}

int GrowingNetwork::signalsPerSplit() const
{
    const int lambda = parameters_.signalsPerSplit;
    return rules_.youngSplitTwiceAsOften && isYoung() ? (lambda + 1) / 2 : lambda;
}

VertexId GrowingNetwork::splitMostActive()
{
    return splitOff(counters_.highest());
}

VertexId GrowingNetwork::splitOff(VertexId v)
{
    const int edge = longestEdge(mesh_, v);
    return splitStar(rules_.splitsEvenValences ? balancedSplit(mesh_, v, edge)
                                               : halvingSplit(mesh_, v, edge),
                     (mesh_.position(v) + mesh_.position(mesh_.ring(v)[edge])) / 2);
}

VertexId GrowingNetwork::splitStar(const StarSplit &star, const Point3 &position)
{
    const VertexId v = star.vertex;
    const VertexId w = mesh_.addVertex(position);
    split(mesh_, v, star.first, star.last, w);
    shareCounter(v, w);
    if (parameters_.edgeFlips) {
        evenValencesAround(mesh_, v);
        evenValencesAround(mesh_, w);
    }
    updateDecay();
    return w;
}

void GrowingNetwork::shareCounter(VertexId v, VertexId w)
{
    const double counter = counters_.value(v);
    const Scalar areaOfV = voronoiArea(v);
    const Scalar areaOfW = voronoiArea(w);
    const Scalar both = areaOfV + areaOfW;
    const double share = both > 0 ? static_cast<double>(areaOfV / both) : 0.5;
    counters_.set(v, counter * share);
    counters_.set(w, counter * (1 - share));
}

Scalar GrowingNetwork::voronoiArea(VertexId v) const
{
    const Scalar averageEdge = meanEdge(mesh_, v);
    const Scalar area = averageEdge * averageEdge;
    return mesh_.isOnBoundary(v) ? area / 2 : area;
}

std::uint64_t GrowingNetwork::inactivityWindow() const
{
    const int vertices = std::max(vertexCount(), fewVertices);
    return static_cast<std::uint64_t>(parameters_.inactivityFactor) *
           static_cast<std::uint64_t>(vertices);
}

bool GrowingNetwork::collapseIsDue() const
{
    return signals_ - lastCollapse_ >= inactivityWindow();
}

bool GrowingNetwork::isInactive(VertexId v) const
{
    return signals_ - lastWin_[v] >= inactivityWindow();
}

void GrowingNetwork::collapseInactive(const SampleSupport &support)
{
    lastCollapse_ = signals_;
    refused_.clear(); // since when all has moved, and the network has grown by an eighth
    std::vector<VertexId> inactive;
    forEachVertex(mesh_, [&](VertexId v) {
        if (isInactive(v))
            inactive.push_back(v);
    });
    collapse(inactive, support);
}

void GrowingNetwork::collapse(const std::vector<VertexId> &vertices, const SampleSupport &support)
{
    judgeOpenness(support);
    for (const VertexId v : vertices)
        if (const VertexId into = bestCollapse(mesh_, v); into != noVertex)
            neuralmesh::collapse(mesh_, v, into);
    fillNotches(mesh_);
    if (!isOpen_ && isClosed(mesh_)) {
        retractWebs(mesh_, support);
        if (rules_.websAreTakenOut && vertexCount() >= webVertices)
            removeWebs(support);
    }
    updateDecay();
}

/// Once. Webs of an open surface are its closing sheet, and would be laid onto its other side.
void GrowingNetwork::judgeOpenness(const SampleSupport &support)
{
    if (isJudged_ || vertexCount() < judgedVertices)
        return;
    isOpen_ = unsupportedShare(mesh_, support) > shareOfOpenSurface;
    isJudged_ = true;
}

void GrowingNetwork::removeWebs(const SampleSupport &support)
{
    for (const Refilling &web : findWebs(mesh_, support, refused_)) {
        refillDisc(mesh_, web.rim, web.interior, web.triangles);
        ++websRemoved_;
    }
}

void GrowingNetwork::vertexAdded(VertexId v)
{
    ++added_;
    enrol(v);
}

void GrowingNetwork::enrol(VertexId v)
{
    if (grid_)
        grid_->insert(v, mesh_.position(v));
    counters_.insert(v, 0);
    lastWin_[v] = signals_;
}

void GrowingNetwork::vertexRemoved(VertexId v)
{
    ++removed_;
    if (grid_)
        grid_->erase(v);
    counters_.erase(v);
}

void GrowingNetwork::updateDecay()
{
    decayPerSignal_ = nthRoot(parameters_.counterDecay, vertexCount());
}

} // namespace neuralmesh
