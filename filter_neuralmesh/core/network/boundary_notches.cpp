// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/boundary_notches.h"

#include <algorithm>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/star_normal.h"
#include "core/mesh/triangle.h"

namespace neuralmesh {
namespace {

/// Cosine of 60 degrees, the angle of a notch that is filled, and the most that the walls of a slit
/// open.
constexpr Scalar notchCosine = 0.5;
/// The width of a slit whose bottom is an edge, in lengths of the edges beside it.
constexpr Scalar slitWidth = 0.5;

Scalar boundaryCosine(const NeuralMesh &mesh, VertexId v)
{
    return cosineAt(mesh.position(v), mesh.position(previousOnBoundary(mesh, v)),
                    mesh.position(nextOnBoundary(mesh, v)));
}

/// Whether the faces around v take more than a half turn.
bool isReflex(const NeuralMesh &mesh, VertexId v)
{
    const Point3 normal = starNormal(mesh, v);
    const Point3 toNext = mesh.position(nextOnBoundary(mesh, v)) - mesh.position(v);
    for (const VertexId u : mesh.ring(v))
        if ((toNext ^ (mesh.position(u) - mesh.position(v))) * normal < 0)
            return true;
    return false;
}

/// Whether the boundary edge from v on is the bottom of a slit, narrow between its walls.
bool isSlitBottom(const NeuralMesh &mesh, VertexId v)
{
    const VertexId end = nextOnBoundary(mesh, v);
    const Point3 bottom = mesh.position(end) - mesh.position(v);
    const Point3 wall = mesh.position(previousOnBoundary(mesh, v)) - mesh.position(v);
    const Point3 otherWall = mesh.position(nextOnBoundary(mesh, end)) - mesh.position(end);
    const Scalar width = bottom.Norm();
    return width < slitWidth * std::min(wall.Norm(), otherWall.Norm()) &&
           Point3(wall).Normalize() * Point3(otherWall).Normalize() > notchCosine &&
           isReflex(mesh, v) && isReflex(mesh, end);
}

} // namespace

bool isNotch(const NeuralMesh &mesh, VertexId v)
{
    return mesh.isOnBoundary(v) &&
           ((boundaryCosine(mesh, v) > notchCosine && isReflex(mesh, v)) || isSlitBottom(mesh, v));
}

int fillNotches(NeuralMesh &mesh)
{
    std::vector<VertexId> open;
    forEachVertex(mesh, [&](VertexId v) {
        if (isNotch(mesh, v))
            open.push_back(v);
    });
    int filled = 0;
    while (!open.empty()) {
        const VertexId v = open.back();
        open.pop_back();
        if (!isNotch(mesh, v) || !canCloseOver(mesh, v))
            continue;
        // Filling one may make notches of its ends, and bottoms of the edges before them.
        const VertexId previous = previousOnBoundary(mesh, v);
        const VertexId next = nextOnBoundary(mesh, v);
        open.insert(open.end(), {previousOnBoundary(mesh, previous), previous, next});
        closeOver(mesh, v);
        ++filled;
    }
    return filled;
}

} // namespace neuralmesh
