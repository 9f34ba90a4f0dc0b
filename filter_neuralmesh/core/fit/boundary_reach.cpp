// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/boundary_reach.h"

#include <algorithm>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/triangle.h"
#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// How far the strip reaches into the face, in heights of the face.
constexpr double depthOfStrip = 0.25;
/// How far off the boundary may lie, in heights of the face. Offsets outwards count no more: a move
/// takes a share of an edge at the most. Before any sample is seen, a vertex is expected so far
/// from the middle of its neighbours along the boundary (standard deviation).
constexpr double mostOffset = 1;
/// What is left of the sums of the last sweep.
constexpr double memory = 0.85;

/// A face at a boundary edge.
struct EdgeFace {
    Point3 outwards; ///< unit, across the edge, in the face's plane
    Scalar height;   ///< of the face over the edge
};

EdgeFace edgeFace(const NeuralMesh &mesh, VertexId start, VertexId end, VertexId apex)
{
    const Point3 &a = mesh.position(start);
    const Point3 &b = mesh.position(end);
    const Point3 &c = mesh.position(apex);
    const Point3 outwards = ((b - a) ^ unitNormal({a, b, c})).Normalize();
    return {outwards, (a - c) * outwards};
}

} // namespace

void BoundaryReach::fade(double mostInformation)
{
    sweeps_ = memory * sweeps_ + 1;
    independence_ = std::min(1.0, mostInformation / sweeps_);
    forEachVertex(mesh_, [&](VertexId v) {
        for (Share *share : {&strips_[v].start, &strips_[v].end})
            *share = {memory * share->weight, memory * share->offset, memory * share->depth,
                      memory * share->samples};
    });
}

void BoundaryReach::add(const StarProjection &p)
{
    for (int k = 0; k < 3; ++k) {
        const VertexId start = p.corners[k];
        const VertexId end = p.corners[(k + 1) % 3];
        if (mesh_.isOnBoundary(start) && nextOnBoundary(mesh_, start) == end)
            addToStrip(start, end, p.corners[(k + 2) % 3], p);
    }
}

void BoundaryReach::addToStrip(VertexId start, VertexId end, VertexId apex, const StarProjection &p)
{
    const EdgeFace face = edgeFace(mesh_, start, end, apex);
    if (!(face.height > 0))
        return;
    const auto weightOf = [&](VertexId corner) {
        return p.weights[std::find(p.corners, p.corners + 3, corner) - p.corners];
    };
    const Scalar inner = weightOf(apex);
    if (inner > depthOfStrip)
        return;
    const double offset = inner > 0
                              ? -inner * face.height
                              : std::min(p.residual * face.outwards, mostOffset * face.height);
    // The face is the narrower the further in: there, a sample stands for more.
    const double narrowness = 1 / (1 - inner);
    // Shared by the place along the edge: otherwise a boundary that goes to and fro, its edges
    // right in the mean, would be right.
    const auto give = [&](Share &share, double part) {
        share.weight += part * narrowness;
        share.offset += part * narrowness * offset;
        share.depth += part * narrowness * depthOfStrip * face.height;
        share.samples += part;
    };
    const double along = weightOf(end) * narrowness;
    give(strips_[start].start, 1 - along);
    give(strips_[start].end, along);
}

void BoundaryReach::follow(const VertexData<Point3> &before)
{
    forEachVertex(mesh_, [&](VertexId start) {
        if (!mesh_.isOnBoundary(start))
            return;
        const VertexId end = nextOnBoundary(mesh_, start);
        const Point3 outwards = edgeFace(mesh_, start, end, mesh_.ring(start)[1]).outwards;
        const double ofStart = (mesh_.position(start) - before[start]) * outwards;
        const double ofEnd = (mesh_.position(end) - before[end]) * outwards;
        const auto move = [&](Share &share, double own, double other) {
            // Samples of a share lie a third of the edge from its end, in the mean.
            const double moved = (2 * own + other) / 3;
            share.offset -= share.weight * moved;
            share.depth += share.weight * moved;
        };
        move(strips_[start].start, ofStart, ofEnd);
        move(strips_[start].end, ofEnd, ofStart);
    });
}

BoundaryReach::Pull BoundaryReach::pull(VertexId v, const Eigen::Vector3d &toCentre) const
{
    Pull pull;
    const VertexId previous = previousOnBoundary(mesh_, v);
    pullAcross(v, strips_[v].start, toCentre, pull);
    pullAcross(previous, strips_[previous].end, toCentre, pull);
    return pull;
}

void BoundaryReach::pullAcross(VertexId start, const Share &share, const Eigen::Vector3d &toCentre,
                               Pull &pull) const
{
    const EdgeFace face =
        edgeFace(mesh_, start, nextOnBoundary(mesh_, start), mesh_.ring(start)[1]);
    const Eigen::Vector3d outwards = toEigen(face.outwards);
    const Eigen::Matrix3d across = outwards * outwards.transpose();
    const double squaredHeight = face.height * face.height;
    const double expected = 1 / (mostOffset * mostOffset * squaredHeight);
    pull.system += across * expected;
    pull.pull += across * toCentre * expected;
    if (!(share.samples > 0))
        return;
    const double reach = (2 * share.offset + share.depth) / share.weight;
    // Twice the mean of an even spread. Were the spread taken for as wide as it is found, samples
    // that reach further would count less.
    const double variance =
        4 * depthOfStrip * depthOfStrip / 12 / (independence_ * share.samples) * squaredHeight;
    pull.system += across / variance;
    pull.pull += outwards * (reach / variance);
}

} // namespace neuralmesh
