// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/neighbour_smoothing.h"

#include <algorithm>

#include "core/mesh/boundary.h"

namespace neuralmesh {
namespace {

NeighbourSmoothing::Neighbour insideSurface(const NeuralMesh &mesh, VertexId v)
{
    const NeighbourRing &ring = mesh.ring(v);
    const Point3 &centre = mesh.position(v);
    Point3 normal(0, 0, 0);
    Point3 sum(0, 0, 0); // relative to the centre
    Point3 previous = mesh.position(ring[ring.size() - 1]) - centre;
    for (const VertexId u : ring) {
        const Point3 edge = mesh.position(u) - centre;
        normal += previous ^ edge;
        sum += edge;
        previous = edge;
    }
    const auto valence = static_cast<Scalar>(ring.size());
    return {centre, sum + centre * valence, normal.Normalize(), {0, 0, 0}, 1 / valence, false};
}

NeighbourSmoothing::Neighbour onBoundary(const NeuralMesh &mesh, VertexId v)
{
    const Point3 &next = mesh.position(nextOnBoundary(mesh, v));
    const Point3 &previous = mesh.position(previousOnBoundary(mesh, v));
    return {mesh.position(v), next + previous, (next - previous).Normalize(),
            {0, 0, 0},        Scalar(0.5),     true};
}

bool touchesBoundary(const NeuralMesh &mesh, VertexId v)
{
    const NeighbourRing &ring = mesh.ring(v);
    return ring.isOpen() ||
           std::any_of(ring.begin(), ring.end(), [&](VertexId u) { return mesh.isOnBoundary(u); });
}

} // namespace

const std::vector<NeighbourSmoothing::Neighbour> &NeighbourSmoothing::smooth(const NeuralMesh &mesh,
                                                                             VertexId winner)
{
    // Normals and sums are taken once for all passes. Then a pass only follows what the smoothed
    // vertices do to each other's sums, each to those of the two next to it on the ring: normals
    // hardly turn, and other neighbours among them (chords of the ring) are rare.
    neighbours_.clear();
    for (const VertexId v : mesh.ring(winner))
        neighbours_.push_back(mesh.isOnBoundary(v) ? onBoundary(mesh, v) : insideSurface(mesh, v));
    const bool isAtBoundary = touchesBoundary(mesh, winner);
    for (int pass = 0; pass < passes_; ++pass) {
        for (Neighbour &v : neighbours_) {
            const Point3 laplacian = v.sum * v.share - v.position; // equation 3
            const Point3 alongAxis = v.axis * (laplacian * v.axis);
            const Point3 tangential = v.isOnBoundary ? alongAxis : laplacian - alongAxis; // 4
            v.step = tangential * rate_;                                                  // 5
            v.position += v.step;
        }
        if (isAtBoundary)
            followStepsAtBoundary(mesh, winner);
        else
            followSteps();
    }
    return neighbours_;
}

void NeighbourSmoothing::followSteps()
{
    const std::size_t count = neighbours_.size();
    for (std::size_t i = 0; i < count; ++i)
        neighbours_[i].sum += neighbours_[i + 1 < count ? i + 1 : 0].step +
                              neighbours_[i > 0 ? i - 1 : count - 1].step;
}

/// The same, where neighbours count that are joined, and on a boundary along it.
void NeighbourSmoothing::followStepsAtBoundary(const NeuralMesh &mesh, VertexId winner)
{
    const NeighbourRing &ring = mesh.ring(winner);
    const auto follow = [&](int place, int other) {
        const VertexId v = ring[place];
        if (!mesh.isOnBoundary(v) || isBoundaryEdge(mesh, v, ring[other]))
            neighbours_[static_cast<std::size_t>(place)].sum +=
                neighbours_[static_cast<std::size_t>(other)].step;
    };
    for (int i = 0; i < ring.faceCount(); ++i) {
        follow(i, ring.next(i));
        follow(ring.next(i), i);
    }
}

} // namespace neuralmesh
