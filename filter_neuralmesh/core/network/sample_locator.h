// SPDX-License-Identifier: GPL-3.0-or-later
// Where samples lie on the mesh, many at a time, while no vertex moves.
#pragma once

#include <vector>

#include "core/network/star_projection.h"
#include "core/parallel/workers.h"
#include "core/space/point_grid.h"

namespace neuralmesh {

/// The point of the mesh nearest to the sample: on the star of the vertex that is nearest to it, or
/// on that of another one not further from it than `reach`. Where two sheets run close to each
/// other, the nearest vertex may lie on one and the nearest face on the other. Of several stars
/// that hold the point, it is given by that of the nearest vertex, or of the lowest id.
template <class Grid>
StarProjection projectOnSheets(const NeuralMesh &mesh, const Grid &grid, VertexId nearest,
                               const Point3 &sample, Scalar reach)
{
    StarProjection best = projectOnStar(mesh, nearest, sample);
    grid.forEachWithin(sample, reach, [&](VertexId v) {
        if (v == nearest || mesh.ring(nearest).contains(v))
            return;
        const StarProjection p = projectOnStar(mesh, v, sample);
        const bool comesFirst = best.corners[0] != nearest && v < best.corners[0];
        if (p.squaredDistance < best.squaredDistance ||
            (p.squaredDistance == best.squaredDistance && comesFirst))
            best = p;
    });
    return best;
}

/// How far around a sample other sheets are looked for, given its nearest vertex.
Scalar reachForSheets(const NeuralMesh &mesh, VertexId nearest, const Point3 &sample);

/// Answers as an index of the vertices does and as projectOnSheets() does, to the last bit, and
/// faster: it knows of each vertex how far from it all those are that are no neighbours of it. A
/// vertex that is nearer to a sample than all its neighbours, and than half of that, is the nearest
/// of all; and where no other comes within reach of the sample, there is no other sheet.
class SampleLocator {
public:
    /// Of a mesh most of which is within the bounds, and which must stay as it is meanwhile.
    SampleLocator(const NeuralMesh &mesh, const Box3 &bounds, Workers &workers);

    /// The vertex nearest to the sample, found by walking over the mesh from the hint, which may be
    /// noVertex; the lowest id of several at the same distance.
    VertexId nearestVertex(const Point3 &sample, VertexId hint) const;

    StarProjection project(VertexId nearest, const Point3 &sample) const;

    /// The same to the last place: also looks at the stars of the nearest vertex's neighbours,
    /// which seldom hold a nearer face than its own. For measuring.
    StarProjection projectExactly(VertexId nearest, const Point3 &sample) const;

    /// Calls take(i, nearest) for every sample, on the workers' threads, with the vertex
    /// nearest to it. Samples that follow each other should be near each other.
    template <class Take>
    void forEachNearest(Workers &workers, const std::vector<Point3> &samples,
                        const Take &take) const
    {
        workers.forEachChunk(samples.size(), samplesOfChunk,
                             [&](std::size_t first, std::size_t end, int) {
                                 VertexId nearest = noVertex;
                                 for (std::size_t i = first; i < end; ++i) {
                                     nearest = nearestVertex(samples[i], nearest);
                                     take(i, nearest);
                                 }
                             });
    }

    static constexpr std::size_t samplesOfChunk = 1024;

private:
    /// Around a vertex.
    struct Surroundings {
        Scalar clearance = 0; ///< no vertex but its neighbours is nearer than that
        Scalar sheets = 0;    ///< how far around a sample other sheets are looked for, at the least
    };

    Surroundings surroundings(VertexId v) const;

    const NeuralMesh &mesh_;
    PointGrid grid_;
    std::vector<Surroundings> around_; ///< by id
};

} // namespace neuralmesh
