// SPDX-License-Identifier: GPL-3.0-or-later
// What every result keeps, whatever was asked for: by the plain arrays that a user gets, and apart
// from how they were made.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/space/plain_points.h"
#include "neuralmesh/reconstruct.h"

namespace neuralmesh::test {

/// How far a vertex may lie outside the box of the points, in its diagonals, with some rounding.
constexpr double mostOutside = 0.05 + 1e-9;

/// Directed edges of the triangles, each with the third corner; empty where one occurs twice.
inline std::map<std::pair<VertexId, VertexId>, VertexId> directedEdges(const Mesh &mesh)
{
    std::map<std::pair<VertexId, VertexId>, VertexId> edges;
    for (const Corners &face : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            if (!edges.insert({{face[corner], face[(corner + 1) % 3]}, face[(corner + 2) % 3]})
                     .second)
                return {};
    return edges;
}

/// Whether the faces around each vertex are one fan: as many as are met by walking round it.
inline bool hasOneFanEach(const Mesh &mesh,
                          const std::map<std::pair<VertexId, VertexId>, VertexId> &edges)
{
    std::vector<int> faces(mesh.positions.size(), 0);
    std::vector<VertexId> start(mesh.positions.size(), 0);
    for (const auto &[edge, third] : edges) {
        ++faces[edge.first];
        const bool isFirst = edges.count({edge.second, edge.first}) == 0;
        if (isFirst || faces[edge.first] == 1)
            start[edge.first] = edge.second;
    }
    for (const auto &[edge, third] : edges) // a boundary's first face, whatever came after it
        if (edges.count({edge.second, edge.first}) == 0)
            start[edge.first] = edge.second;
    for (VertexId v = 0; v < mesh.positions.size(); ++v) {
        int met = 0;
        VertexId u = start[v];
        do {
            const auto face = edges.find({v, u});
            if (face == edges.end())
                break;
            ++met;
            u = face->second;
        } while (u != start[v] && met <= faces[v]);
        if (met != faces[v])
            return false;
    }
    return true;
}

/// What is wrong with the mesh as a two-manifold without loose vertices, or nothing.
inline std::string brokenManifold(const Mesh &mesh, const Report &report)
{
    std::set<VertexId> named;
    for (const Corners &face : mesh.triangles)
        named.insert(face.begin(), face.end());
    if (!named.empty() && *named.rbegin() >= mesh.positions.size())
        return "a face names a vertex that is not there";
    if (named.size() != mesh.positions.size())
        return "a vertex is of no face";
    const auto edges = directedEdges(mesh);
    if (edges.size() != 3 * mesh.triangles.size())
        return "two faces have an edge in the same direction";
    const bool isOpen = std::any_of(edges.begin(), edges.end(), [&](const auto &entry) {
        return edges.count({entry.first.second, entry.first.first}) == 0;
    });
    if (isOpen != (report.boundaryLoops > 0))
        return "the number of boundaries is another";
    return hasOneFanEach(mesh, edges) ? "" : "several fans of faces meet at one vertex";
}

/// What is wrong with the places of the vertices, or nothing. A starting mesh that was given may
/// lie anywhere.
inline std::string brokenPlaces(const Mesh &mesh, const Sampler &sampler, bool isStartGiven)
{
    const Box3 bounds = toVcg(sampler.bounds());
    const double most = mostOutside * bounds.Diag();
    for (const Point &position : mesh.positions) {
        const Point3 place = toVcg(sampler.frame().toUnit(position));
        for (int axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(position[static_cast<std::size_t>(axis)]))
                return "a vertex is not finite";
            if (!isStartGiven &&
                (place[axis] < bounds.min[axis] - most || place[axis] > bounds.max[axis] + most))
                return "a vertex is far outside the box of the points";
        }
    }
    return {};
}

/// The first promise that a result breaks, in words, or an empty string.
inline std::string brokenPromise(const Result &result, const Sampler &sampler,
                                 const GrowthParameters &parameters)
{
    const Report &report = result.report;
    const auto vertices = static_cast<int>(result.mesh.positions.size());
    if (report.vertices != vertices ||
        report.faces != static_cast<int>(result.mesh.triangles.size()))
        return "the report has other counts";
    if (report.reachedTarget != (report.timeUp == TimeUp::no))
        return "the target was missed though there was time";
    if (report.reachedTarget && vertices != parameters.targetVertexCount)
        return "the number of vertices is not that asked for";
    if (!(report.rmsError <= report.maxError && std::isfinite(report.maxError)))
        return "the errors contradict each other";
    if (std::string broken = brokenManifold(result.mesh, report); !broken.empty())
        return broken;
    return brokenPlaces(result.mesh, sampler, parameters.startMesh == StartMesh::given);
}

} // namespace neuralmesh::test
