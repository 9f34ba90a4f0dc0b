// SPDX-License-Identifier: GPL-3.0-or-later
// Where samples lie on the mesh, many at a time, while no vertex moves.
#pragma once

#include <vector>

#include "core/network/star_projection.h"
#include "core/parallel/workers.h"
#include "core/space/vertex_grid.h"

namespace neuralmesh {

/// The point of the mesh nearest to the sample: on the star of the vertex that is nearest to it, or
/// on that of another one not further from it than `reach`. Where two sheets run close to each
/// other, the nearest vertex may lie on one and the nearest face on the other.
StarProjection projectOnSheets(const NeuralMesh &mesh, const VertexGrid &grid, VertexId nearest,
                               const Point3 &sample, Scalar reach);

/// How far around a sample other sheets are looked for, given its nearest vertex.
Scalar reachForSheets(const NeuralMesh &mesh, VertexId nearest, const Point3 &sample);

/// Answers as the grid does and as projectOnSheets() does, to the last bit, and
/// faster: it knows of each vertex how far from it all those are that are no neighbours of it. A
/// vertex that is nearer to a sample than all its neighbours, and than half of that, is the nearest
/// of all; and where no other comes within reach of the sample, there is no other sheet.
class SampleLocator {
public:
    /// Both must stay as they are meanwhile.
    SampleLocator(const NeuralMesh &mesh, const VertexGrid &grid, Workers &workers);

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
    const VertexGrid &grid_;
    std::vector<Surroundings> around_; ///< by id
};

} // namespace neuralmesh
