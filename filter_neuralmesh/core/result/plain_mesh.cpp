// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/plain_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/manifold_mesh.h"
#include "core/space/plain_points.h"
#include "neuralmesh/errors.h"

namespace neuralmesh {

Mesh plainMesh(const NeuralMesh &network, const UnitFrame &frame)
{
    Mesh mesh;
    mesh.positions.reserve(static_cast<std::size_t>(network.vn));
    mesh.triangles.reserve(static_cast<std::size_t>(network.fn));
    std::vector<VertexId> places(network.idBound());
    for (VertexId v = 0; v < network.idBound(); ++v) {
        if (!network.isLive(v))
            continue;
        places[v] = static_cast<VertexId>(mesh.positions.size());
        mesh.positions.push_back(frame.toWorld(toPlain(network.position(v))));
    }
    for (const NeuralFace &face : network.face) {
        Corners corners;
        for (int c = 0; c < 3; ++c)
            corners[static_cast<std::size_t>(c)] = places[vcg::tri::Index(network, face.cV(c))];
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

void makeNetwork(NeuralMesh &network, const Mesh &mesh, const UnitFrame &frame)
{
    using Problem = InvalidStartingMesh::Problem;
    std::vector<Point3> points;
    points.reserve(mesh.positions.size());
    for (const Point &p : mesh.positions) {
        if (!std::isfinite(toVcg(p).SquaredNorm()))
            throw InvalidStartingMesh(Problem::notFinite);
        points.push_back(toVcg(frame.toUnit(p)));
    }
    const auto isBeyond = [&](VertexId v) { return v >= points.size(); };
    const auto unknown =
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                      [&](const Corners &f) { return std::any_of(f.begin(), f.end(), isBeyond); });
    if (unknown > 0)
        throw InvalidStartingMesh(Problem::unknownVertex, static_cast<std::uint64_t>(unknown));
    makeManifold(network, points, mesh.triangles);
}

} // namespace neuralmesh
