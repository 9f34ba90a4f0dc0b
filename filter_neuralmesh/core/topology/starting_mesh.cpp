// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/starting_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/manifold_mesh.h"
#include "core/mesh/ring_topology.h"
#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

void makeOctahedron(NeuralMesh &mesh, Scalar r)
{
    makeManifold(mesh, {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}},
                 {{{0, 2, 4}},
                  {{2, 1, 4}},
                  {{1, 3, 4}},
                  {{3, 0, 4}},
                  {{2, 0, 5}},
                  {{1, 2, 5}},
                  {{3, 1, 5}},
                  {{0, 3, 5}}});
}

/// Poles, and two rings of five corners between them, the lower turned by half a step. Cosines and
/// sines of multiples of 36 degrees are roots: the C library's differ from place to place.
void makeIcosahedron(NeuralMesh &mesh, Scalar r)
{
    const Scalar root = std::sqrt(Scalar(5));
    const Scalar height = r / root;
    const Scalar cosines[] = {1, (1 + root) / 4, (root - 1) / 4, (1 - root) / 4, -(1 + root) / 4};
    const Scalar sineOf36 = std::sqrt(10 - 2 * root) / 4;
    const Scalar sineOf72 = std::sqrt(10 + 2 * root) / 4;
    const Scalar sines[] = {0, sineOf36, sineOf72, sineOf72, sineOf36};
    std::vector<Point3> points{{0, 0, r}, {0, 0, -r}};
    std::vector<Corners> faces;
    for (VertexId i = 0; i < 5; ++i)
        for (const int lower : {0, 1}) {
            const auto steps = 2 * i + static_cast<VertexId>(lower);
            const Scalar halfTurn = steps < 5 ? 1 : -1;
            points.emplace_back(2 * height * halfTurn * cosines[steps % 5],
                                2 * height * halfTurn * sines[steps % 5],
                                lower == 1 ? -height : height);
        }
    for (VertexId i = 0; i < 5; ++i) {
        const VertexId up = 2 + 2 * i;
        const VertexId down = up + 1;
        const VertexId nextUp = 2 + 2 * ((i + 1) % 5);
        const VertexId nextDown = nextUp + 1;
        faces.insert(faces.end(), {{{0, up, nextUp}},
                                   {{up, down, nextUp}},
                                   {{nextUp, down, nextDown}},
                                   {{1, nextDown, down}}});
    }
    makeManifold(mesh, points, faces);
}

/// Centred, with a variance of 1 of its corners along each axis.
void makeSolid(NeuralMesh &mesh, StartMesh solid)
{
    const Scalar circumradius = std::sqrt(Scalar(3));
    switch (solid) {
    case StartMesh::octahedron: return makeOctahedron(mesh, circumradius);
    case StartMesh::icosahedron: return makeIcosahedron(mesh, circumradius);
    default: return makeTetrahedron(mesh, {0, 0, 0}, circumradius);
    }
}

} // namespace

void makeTetrahedron(NeuralMesh &mesh, const Point3 &centre, Scalar circumradius)
{
    // Every other corner of a cube.
    static constexpr int corners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    static constexpr VertexId rings[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    mesh.Clear();
    const Scalar halfEdge = circumradius / std::sqrt(Scalar(3));
    for (const auto &corner : corners)
        mesh.addVertex(centre + Point3(corner[0], corner[1], corner[2]) * halfEdge);
    for (VertexId v = 0; v < 4; ++v)
        for (const VertexId u : rings[v])
            mesh.ring(v).pushBack(u);
}

void makeStartingSolid(NeuralMesh &mesh, StartMesh solid, const std::vector<Point3> &samples)
{
    constexpr double leastDeviation = 0.01;
    PrincipalAxes frame = principalAxes(samples);
    if (frame.axes.determinant() < 0)
        frame.axes.col(0) *= -1;
    for (int i = 0; i < 3; ++i)
        frame.axes.col(i) *= std::max(std::sqrt(frame.variances[i]), leastDeviation);

    makeSolid(mesh, solid);
    for (NeuralVertex &vertex : mesh.vert) {
        const Eigen::Vector3d corner = frame.mean + frame.axes * toEigen(vertex.cP());
        vertex.P() = Point3(corner[0], corner[1], corner[2]);
    }
}

} // namespace neuralmesh
