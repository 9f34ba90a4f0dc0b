// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/self_intersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/mesh/ring_topology.h"
#include "core/space/box_tree.h"

namespace neuralmesh {
namespace {

/// Leaves of the tree, each of a few faces, that a thread tests at a time.
constexpr std::size_t leavesOfChunk = 64;

/// A corner counts as in the plane of a face up to this height, in lengths of the edge at it.
/// Rounding leaves heights of 1e-16 in the unit frame: even of edges of 1e-5, 1e-11.
constexpr Scalar flatness = 1e-9;

using Corners3 = std::array<Point3, 3>;

/// Six times the volume of a tetrahedron; positive where d is on the side of the normal of a, b, c.
Scalar volume(const Point3 &a, const Point3 &b, const Point3 &c, const Point3 &d)
{
    return ((b - a) ^ (c - a)) * (d - a);
}

/// Whether the edge from p to q passes through the triangle. What is small is so by the lengths of
/// the edges: VCG takes a determinant below 1e-6 for parallel, which that of an edge and a face of
/// 0.001 always is.
bool pierces(const Point3 &p, const Point3 &q, const Corners3 &t)
{
    const Point3 normal = (t[1] - t[0]) ^ (t[2] - t[0]);
    const Scalar above = normal * (p - t[0]);
    const Scalar below = normal * (q - t[0]);
    const Scalar least = flatness * (t[1] - t[0]).Norm() * (t[2] - t[0]).Norm() * (q - p).Norm();
    if (std::min(above, below) > -least || std::max(above, below) < least)
        return false;
    const Scalar a = volume(p, q, t[0], t[1]);
    const Scalar b = volume(p, q, t[1], t[2]);
    const Scalar c = volume(p, q, t[2], t[0]);
    return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

Corners3 cornersOf(const NeuralFace &face)
{
    return {face.cP(0), face.cP(1), face.cP(2)};
}

bool isCornerOf(const NeuralVertex *v, const NeuralFace &face)
{
    return v == face.cV(0) || v == face.cV(1) || v == face.cV(2);
}

/// Whether an edge of one face passes through the other. Those at a vertex of both do not, so that
/// faces with an edge in common cannot.
bool hasEdgeThrough(const NeuralFace &face, const NeuralFace &other)
{
    const Corners3 corners = cornersOf(other);
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        if (!isCornerOf(face.cV(i), other) && !isCornerOf(face.cV(next), other) &&
            pierces(face.cP(i), face.cP(next), corners))
            return true;
    }
    return false;
}

bool isInPlaneOf(const Corners3 &t, const Corners3 &other)
{
    const Point3 normal = (t[1] - t[0]) ^ (t[2] - t[0]);
    const Scalar lengths = (t[1] - t[0]).Norm() * (t[2] - t[0]).Norm();
    return std::all_of(other.begin(), other.end(), [&](const Point3 &p) {
        return std::abs(normal * (p - t[0])) <= flatness * lengths * (p - t[0]).Norm();
    });
}

/// Whether an edge of a triangle has all of another one, in its plane, on its other side.
bool hasEdgeBetween(const Corners3 &t, const Corners3 &other)
{
    const Point3 normal = ((t[1] - t[0]) ^ (t[2] - t[0])).Normalize();
    for (std::size_t i = 0; i < 3; ++i) {
        const Point3 edge = t[(i + 1) % 3] - t[i];
        const auto isBeyond = [&](const Point3 &p) {
            return (edge ^ (p - t[i])) * normal <= flatness * edge.Norm() * (p - t[i]).Norm();
        };
        if (std::all_of(other.begin(), other.end(), isBeyond))
            return true;
    }
    return false;
}

/// Whether the faces lie in one plane, and one upon the other, by more than a border; those with an
/// edge in common do not, of which one may be folded onto the other.
bool overlapInPlane(const NeuralFace &face, const NeuralFace &other)
{
    int shared = 0;
    for (int i = 0; i < 3; ++i)
        shared += isCornerOf(face.cV(i), other) ? 1 : 0;
    const Corners3 t = cornersOf(face);
    const Corners3 u = cornersOf(other);
    return shared < 2 && isInPlaneOf(t, u) && isInPlaneOf(u, t) && !hasEdgeBetween(t, u) &&
           !hasEdgeBetween(u, t);
}

bool cross(const NeuralFace &face, const NeuralFace &other)
{
    return hasEdgeThrough(face, other) || hasEdgeThrough(other, face) ||
           overlapInPlane(face, other);
}

Box3 boundsOf(const NeuralFace &face)
{
    Box3 bounds;
    face.GetBBox(bounds);
    return bounds;
}

/// Sorts, and leaves each only once.
template <class T> void sortOnce(std::vector<T> &values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace

SelfIntersections findSelfIntersections(NeuralMesh &mesh, Workers &workers)
{
    rebuildFaces(mesh);
    std::vector<Box3> bounds;
    bounds.reserve(mesh.face.size());
    for (const NeuralFace &face : mesh.face)
        bounds.push_back(boundsOf(face));
    const BoxTree boxes(std::move(bounds));
    std::vector<std::vector<NeuralFace *>> ofChunks(boxes.leafCount() / leavesOfChunk + 1);
    workers.forEachChunk(
        boxes.leafCount(), leavesOfChunk, [&](std::size_t first, std::size_t end, int) {
            std::vector<NeuralFace *> &crossing = ofChunks[first / leavesOfChunk];
            for (std::size_t leaf = first; leaf < end; ++leaf)
                boxes.forEachPair(leaf, [&](std::uint32_t i, std::uint32_t j) {
                    if (cross(mesh.face[i], mesh.face[j]))
                        crossing.insert(crossing.end(), {&mesh.face[i], &mesh.face[j]});
                });
        });
    std::vector<NeuralFace *> faces;
    for (const std::vector<NeuralFace *> &ofChunk : ofChunks)
        faces.insert(faces.end(), ofChunk.begin(), ofChunk.end());
    sortOnce(faces);
    SelfIntersections found;
    found.faces = static_cast<int>(faces.size());
    for (const NeuralFace *face : faces)
        for (int corner = 0; corner < 3; ++corner)
            found.corners.push_back(static_cast<VertexId>(vcg::tri::Index(mesh, face->cV(corner))));
    sortOnce(found.corners);
    return found;
}

SelfIntersections findSelfIntersections(NeuralMesh &mesh)
{
    Workers alone;
    return findSelfIntersections(mesh, alone);
}

} // namespace neuralmesh
