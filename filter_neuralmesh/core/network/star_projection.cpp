// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/star_projection.h"

#include <algorithm>
#include <limits>

#include "core/mesh/boundary.h"

namespace neuralmesh {
namespace {

struct Barycentric {
    Scalar a, b, c;
};

Scalar ratio(Scalar part, Scalar whole)
{
    return whole > 0 ? std::clamp(part / whole, Scalar(0), Scalar(1)) : Scalar(0);
}

/// An edge from the origin, and what two faces at it share.
struct Spoke {
    Spoke(const Point3 &end, const Point3 &p) : to(end), alongP(end * p), squared(end * end) {}

    Point3 to;
    Scalar alongP; ///< dot product with p
    Scalar squared;
};

/// Coordinates of the point of the triangle (0, b, c) that is nearest to p. The corner, edge or
/// interior whose Voronoi region holds p is found from dot products alone.
Barycentric nearestOnTriangle(const Spoke &b, const Spoke &c)
{
    const Scalar d1 = b.alongP;
    const Scalar d2 = c.alongP;
    if (d1 <= 0 && d2 <= 0)
        return {1, 0, 0};
    const Scalar bb = b.squared;
    const Scalar bc = b.to * c.to;
    const Scalar cc = c.squared;
    const Scalar d3 = d1 - bb;
    const Scalar d4 = d2 - bc;
    if (d3 >= 0 && d4 <= d3)
        return {0, 1, 0};
    const Scalar outsideC = d1 * d4 - d3 * d2;
    if (outsideC <= 0 && d1 >= 0 && d3 <= 0) {
        const Scalar t = ratio(d1, d1 - d3);
        return {1 - t, t, 0};
    }
    const Scalar d5 = d1 - bc;
    const Scalar d6 = d2 - cc;
    if (d6 >= 0 && d5 <= d6)
        return {0, 0, 1};
    const Scalar outsideB = d5 * d2 - d1 * d6;
    if (outsideB <= 0 && d2 >= 0 && d6 <= 0) {
        const Scalar t = ratio(d2, d2 - d6);
        return {1 - t, 0, t};
    }
    const Scalar outsideA = d3 * d6 - d5 * d4;
    if (outsideA <= 0 && d4 >= d3 && d5 >= d6) {
        const Scalar t = ratio(d4 - d3, (d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }
    const Scalar sum = outsideA + outsideB + outsideC;
    if (!(sum > 0)) // a degenerate face
        return {1, 0, 0};
    return {outsideA / sum, outsideB / sum, outsideC / sum};
}

} // namespace

StarProjection projectOnStar(const NeuralMesh &mesh, VertexId v, const Point3 &query)
{
    const NeighbourRing &ring = mesh.ring(v);
    const Point3 &centre = mesh.position(v);
    const Point3 target = query - centre;
    StarProjection best{};
    best.squaredDistance = std::numeric_limits<Scalar>::infinity();
    // Round a closed ring, the first face is that between the last neighbour and the first.
    VertexId a = ring[ring.isOpen() ? 0 : ring.size() - 1];
    Spoke toA(mesh.position(a) - centre, target);
    for (const VertexId *next = ring.begin() + (ring.isOpen() ? 1 : 0); next != ring.end();
         ++next) {
        const VertexId b = *next;
        const Spoke toB(mesh.position(b) - centre, target);
        const Barycentric w = nearestOnTriangle(toA, toB);
        const Point3 residual = target - toA.to * w.b - toB.to * w.c;
        const Scalar d = residual.SquaredNorm();
        if (d < best.squaredDistance)
            best = {{v, a, b}, {w.a, w.b, w.c}, residual, d};
        a = b;
        toA = toB;
    }
    // Faces without an extent have no place of theirs that is nearest.
    if (!(best.squaredDistance < std::numeric_limits<Scalar>::infinity()))
        best = {{v, ring[0], ring[1]}, {1, 0, 0}, target, target.SquaredNorm()};
    return best;
}

bool liesOnBoundary(const NeuralMesh &mesh, const StarProjection &p)
{
    VertexId ends[2];
    int count = 0;
    for (int corner = 0; corner < 3; ++corner)
        if (p.weights[corner] > 0) {
            if (count == 2 || !mesh.isOnBoundary(p.corners[corner]))
                return false;
            ends[count++] = p.corners[corner];
        }
    return count == 1 || isBoundaryEdge(mesh, ends[0], ends[1]);
}

Point3 residualFromSurface(const NeuralMesh &mesh, const StarProjection &p)
{
    if (!liesOnBoundary(mesh, p))
        return p.residual;
    const Point3 normal = unitNormal(
        {mesh.position(p.corners[0]), mesh.position(p.corners[1]), mesh.position(p.corners[2])});
    return normal * (p.residual * normal);
}

VertexId winnerOf(const NeuralMesh &mesh, VertexId nearest, const StarProjection &p)
{
    const bool isOnOwnSheet = p.corners[0] == nearest;
    return isOnOwnSheet && !liesOnBoundary(mesh, p)
               ? nearest
               : p.corners[std::max_element(p.weights, p.weights + 3) - p.weights];
}

Scalar squaredDistanceTo(const Triangle &t, const Point3 &query)
{
    const Point3 toB = t.b - t.a;
    const Point3 toC = t.c - t.a;
    const Point3 target = query - t.a;
    const Barycentric w = nearestOnTriangle({toB, target}, {toC, target});
    return (target - toB * w.b - toC * w.c).SquaredNorm();
}

} // namespace neuralmesh
