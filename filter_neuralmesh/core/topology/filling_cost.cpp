// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/filling_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/triangle.h"
#include "core/network/star_projection.h"

namespace neuralmesh {
namespace {

/// Area counts as if it were so far from the samples, in mean lengths of the loop's edges.
constexpr Scalar distanceOfArea = 0.05;
/// Samples near a face are those nearest to its centre and to places so far from it towards each
/// corner.
constexpr Scalar towardsCorner = 0.75;

Scalar meanSquaredEdge(const NeuralMesh &mesh, const std::vector<VertexId> &loop)
{
    Scalar sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += (mesh.position(loop[i]) - mesh.position(loop[(i + 1) % loop.size()])).SquaredNorm();
    return sum / static_cast<Scalar>(loop.size());
}

Triangle triangleOf(const NeuralMesh &mesh, const Corners &face)
{
    return {mesh.position(face[0]), mesh.position(face[1]), mesh.position(face[2])};
}

} // namespace

FillingCost::FillingCost(const NeuralMesh &mesh, const SampleSupport &support,
                         const std::vector<VertexId> &loop)
    : mesh_(mesh), support_(support), squaredEdge_(meanSquaredEdge(mesh, loop)),
      areaTerm_(distanceOfArea * distanceOfArea * squaredEdge_)
{
}

double FillingCost::squaredDistanceOfEdge(VertexId v, VertexId u) const
{
    return support_.squaredDistance((mesh_.position(v) + mesh_.position(u)) / 2);
}

double FillingCost::weight(const Corners &face, double edgeA, double edgeB, double edgeC) const
{
    const double edges = edgeA + edgeB + edgeC;
    // Without the test, a face without area would hide a forbidden edge.
    if (std::isinf(edges))
        return edges;
    return area(triangleOf(mesh_, face)) * (edges / 3 + areaTerm_);
}

double FillingCost::weight(const Corners &face) const
{
    return weight(face, squaredDistanceOfEdge(face[0], face[1]),
                  squaredDistanceOfEdge(face[1], face[2]), squaredDistanceOfEdge(face[2], face[0]));
}

double FillingCost::weight(const std::vector<Corners> &faces) const
{
    double sum = 0;
    for (const Corners &face : faces)
        sum += weight(face);
    return sum;
}

double FillingCost::sizeInFaces(const std::vector<Corners> &faces) const
{
    Scalar sum = 0;
    for (const Corners &face : faces)
        sum += area(triangleOf(mesh_, face));
    return sum / (std::sqrt(Scalar(3)) / 4 * squaredEdge_);
}

std::vector<FillingCost::Missed> FillingCost::missed(const std::vector<Corners> &faces,
                                                     const DistanceNow &distanceNow) const
{
    std::vector<Missed> found;
    for (const Corners &face : faces) {
        const Triangle t = triangleOf(mesh_, face);
        const Point3 centre = (t.a + t.b + t.c) / 3;
        const auto towards = [&](const Point3 &corner) {
            return centre * (1 - towardsCorner) + corner * towardsCorner;
        };
        for (const Point3 &place : {centre, towards(t.a), towards(t.b), towards(t.c)}) {
            const SampleId id = support_.nearestId(place);
            if (const std::optional<Scalar> now = distanceNow(id))
                found.push_back({support_.samples()[id], area(t) / 4, *now});
        }
    }
    return found;
}

double FillingCost::distances(const std::vector<Missed> &samples, const std::vector<Corners> &faces,
                              double most) const
{
    double sum = 0;
    for (const Missed &missed : samples) {
        if (sum >= most)
            break;
        sum += missed.area * squaredDistance(faces, missed.sample);
    }
    return sum;
}

double FillingCost::squaredDistance(const std::vector<Corners> &faces, const Point3 &sample) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const Corners &face : faces)
        least = std::min(least, squaredDistanceTo(triangleOf(mesh_, face), sample));
    return least;
}

std::vector<Corners> cornersOf(const std::vector<VertexId> &loop,
                               const std::vector<LoopTriangle> &triangles)
{
    std::vector<Corners> faces;
    for (const LoopTriangle &t : triangles)
        faces.push_back({loop[static_cast<std::size_t>(t[0])], loop[static_cast<std::size_t>(t[1])],
                         loop[static_cast<std::size_t>(t[2])]});
    return faces;
}

} // namespace neuralmesh
