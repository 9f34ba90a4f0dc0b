// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/few_points.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "core/mesh/enumeration.h"
#include "core/space/plain_points.h"

namespace neuralmesh {
namespace {

/// Vertices up to which each is put on a point: all pairs are compared.
constexpr std::size_t mostInterpolated = 64;
/// Samples for each point by which all are found: none of 64 is missed but once in 10^12 runs.
constexpr std::size_t samplesPerPoint = 32;
/// How far a vertex may lie outside the bounds of the samples, in their diagonals. On a sphere
/// those of more than a few dozen vertices lie by less than that outside.
constexpr Scalar bulge = 0.05;

std::vector<Point> distinctPoints(const Sampler &sampler, Random &random, std::size_t count)
{
    std::vector<Point> drawn;
    sampler.draw(random, samplesPerPoint * count, drawn);
    std::sort(drawn.begin(), drawn.end());
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    return drawn;
}

Point3 nearBounds(Point3 place, const Box3 &bounds)
{
    const Scalar margin = bulge * bounds.Diag();
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = std::clamp(place[axis], bounds.min[axis] - margin, bounds.max[axis] + margin);
    return place;
}

/// Calls move(v, place) for each vertex that is further outside the bounds than it may be, with the
/// nearest place that it may have. Returns whether there were any.
template <class Move>
bool forEachFarOutside(const NeuralMesh &mesh, const Sampler &sampler, StartMesh start,
                       const Move &move)
{
    if (start == StartMesh::given)
        return false;
    const Box3 bounds = toVcg(sampler.bounds());
    bool isAny = false;
    forEachVertex(mesh, [&](VertexId v) {
        if (const Point3 near = nearBounds(mesh.position(v), bounds); near != mesh.position(v)) {
            move(v, near);
            isAny = true;
        }
    });
    return isAny;
}

} // namespace

bool interpolatePoints(GrowingNetwork &network, const Sampler &sampler, Random &random)
{
    const auto count = static_cast<std::size_t>(network.vertexCount());
    if (count > mostInterpolated || sampler.countDistinctPoints(count + 1) != count)
        return false;
    const std::vector<Point> points = distinctPoints(sampler, random, count);
    if (points.size() != count)
        return false;
    std::vector<std::tuple<Scalar, VertexId, std::size_t>> pairs;
    forEachVertex(network.mesh(), [&](VertexId v) {
        for (std::size_t i = 0; i < count; ++i)
            pairs.emplace_back((network.mesh().position(v) - toVcg(points[i])).SquaredNorm(), v, i);
    });
    std::sort(pairs.begin(), pairs.end());
    std::vector<bool> isTaken(count, false);
    std::vector<bool> isPlaced(network.mesh().idBound(), false);
    for (const auto &[distance, v, i] : pairs)
        if (!isTaken[i] && !isPlaced[v]) {
            isTaken[i] = isPlaced[v] = true;
            network.moveVertex(v, toVcg(points[i]));
        }
    return true;
}

Point3 movedNearBounds(const Point3 &from, const Point3 &move, const Box3 &bounds)
{
    return move == Point3(0, 0, 0) ? from : nearBounds(from + move, bounds);
}

bool bringNearBounds(GrowingNetwork &network, const Sampler &sampler, StartMesh start)
{
    return forEachFarOutside(network.mesh(), sampler, start,
                             [&](VertexId v, const Point3 &near) { network.moveVertex(v, near); });
}

void bringNearBounds(NeuralMesh &mesh, const Sampler &sampler, StartMesh start)
{
    forEachFarOutside(mesh, sampler, start,
                      [&](VertexId v, const Point3 &near) { mesh.position(v) = near; });
}

} // namespace neuralmesh
