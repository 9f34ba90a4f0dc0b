// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/sample_locator.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/edge_lengths.h"
#include "core/parallel/vertex_loops.h"
#include "core/space/vertices_of.h"

namespace neuralmesh {
namespace {

/// How far around a sample other sheets are looked for, in mean lengths of the nearest vertex's
/// edges.
constexpr Scalar sheetDistance = 0.8;

/// Clearances are looked for so far, in the same lengths. Most samples lie within half a length of
/// their nearest vertex: with the distance above, further would tell nothing more.
constexpr Scalar farthestClearance = 1.4;

/// A distance must be so much less than another to be less however both are rounded.
constexpr Scalar rounding = 1 - 1e-9;

} // namespace

Scalar reachForSheets(const NeuralMesh &mesh, VertexId nearest, const Point3 &sample)
{
    return std::max((mesh.position(nearest) - sample).Norm(),
                    sheetDistance * meanEdge(mesh, nearest));
}

SampleLocator::SampleLocator(const NeuralMesh &mesh, const Box3 &bounds, Workers &workers)
    : mesh_(mesh), grid_(verticesOf(mesh, bounds)), around_(mesh.idBound())
{
    forEachVertex(workers, mesh_, [&](VertexId v) { around_[v] = surroundings(v); });
}

SampleLocator::Surroundings SampleLocator::surroundings(VertexId v) const
{
    const Point3 &centre = mesh_.position(v);
    const Scalar spacing = meanEdge(mesh_, v);
    const NeighbourRing &ring = mesh_.ring(v);
    const Scalar least =
        grid_.squaredClearance(centre, farthestClearance * spacing,
                               [&](VertexId u) { return u == v || ring.contains(u); });
    return {rounding * std::sqrt(least), sheetDistance * spacing};
}

VertexId SampleLocator::nearestVertex(const Point3 &sample, VertexId hint) const
{
    if (hint == noVertex)
        return grid_.nearest(sample);
    VertexId nearest = hint;
    Scalar least = (mesh_.position(hint) - sample).SquaredNorm();
    for (VertexId from = noVertex; from != nearest;) {
        from = nearest;
        for (const VertexId u : mesh_.ring(from)) {
            const Scalar d = (mesh_.position(u) - sample).SquaredNorm();
            if (d < least || (d == least && u < nearest)) {
                least = d;
                nearest = u;
            }
        }
    }
    const Scalar clearance = around_[nearest].clearance;
    return 4 * least < clearance * clearance ? nearest : grid_.nearest(sample, {least, nearest});
}

StarProjection SampleLocator::project(VertexId nearest, const Point3 &sample) const
{
    const Scalar distance = (mesh_.position(nearest) - sample).Norm();
    const Surroundings &around = around_[nearest];
    const Scalar reach = std::max(distance, around.sheets);
    return distance + reach < around.clearance
               ? projectOnStar(mesh_, nearest, sample)
               : projectOnSheets(mesh_, grid_, nearest, sample, reach);
}

StarProjection SampleLocator::projectExactly(VertexId nearest, const Point3 &sample) const
{
    StarProjection best = project(nearest, sample);
    for (const VertexId v : mesh_.ring(nearest)) {
        const StarProjection p = projectOnStar(mesh_, v, sample);
        if (p.squaredDistance < best.squaredDistance)
            best = p;
    }
    return best;
}

} // namespace neuralmesh
