// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes that the tests share.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/mesh/ring_topology.h"
#include "core/topology/starting_mesh.h"
#include "tests/points_for_tests.h"

namespace neuralmesh::test {

using Triangle = std::array<VertexId, 3>;

/// Builds the rings of an oriented mesh, open or closed, from its faces.
inline void makeMesh(NeuralMesh &mesh, const std::vector<Point3> &points,
                     const std::vector<Triangle> &faces)
{
    mesh.Clear();
    for (const Point3 &point : points)
        mesh.addVertex(point);
    for (VertexId v = 0; v < points.size(); ++v) {
        // successor[a] = b and predecessor[b] = a for each face (v, a, b)
        std::vector<VertexId> successor(points.size(), noVertex);
        std::vector<VertexId> predecessor(points.size(), noVertex);
        VertexId first = noVertex;
        for (const Triangle &face : faces)
            for (std::size_t corner = 0; corner < 3; ++corner)
                if (face[corner] == v) {
                    first = face[(corner + 1) % 3];
                    successor[first] = face[(corner + 2) % 3];
                    predecessor[successor[first]] = first;
                }
        const VertexId start = first;
        while (predecessor[first] != noVertex && predecessor[first] != start)
            first = predecessor[first];
        if (predecessor[first] != noVertex)
            first = start; // closed
        VertexId a = first;
        do {
            mesh.ring(v).pushBack(a);
            a = successor[a];
        } while (a != first && a != noVertex);
        mesh.ring(v).setOpen(a == noVertex);
    }
}

/// A flat square of `size` by `size` quads of side 1, each cut in two: open, with one boundary.
inline void makeSquare(NeuralMesh &mesh, VertexId size)
{
    std::vector<Point3> points;
    std::vector<Triangle> faces;
    for (VertexId j = 0; j <= size; ++j)
        for (VertexId i = 0; i <= size; ++i)
            points.emplace_back(i, j, 0);
    for (VertexId j = 0; j < size; ++j)
        for (VertexId i = 0; i < size; ++i) {
            const VertexId here = j * (size + 1) + i;
            const VertexId up = here + size + 1;
            faces.push_back({{here, here + 1, up + 1}});
            faces.push_back({{here, up + 1, up}});
        }
    makeMesh(mesh, points, faces);
}

/// A tube of `length` rows of `around` quads, each cut in two: open, with two boundaries.
inline void makeTube(NeuralMesh &mesh, VertexId around, VertexId length)
{
    std::vector<Point3> points;
    std::vector<Triangle> faces;
    for (VertexId j = 0; j <= length; ++j)
        for (VertexId i = 0; i < around; ++i) {
            const double angle = 2 * M_PI * i / around;
            points.emplace_back(std::cos(angle), std::sin(angle), j * 2 * M_PI / around);
        }
    for (VertexId j = 0; j < length; ++j)
        for (VertexId i = 0; i < around; ++i) {
            const VertexId here = j * around + i;
            const VertexId right = j * around + (i + 1) % around;
            faces.push_back({{here, right, right + around}});
            faces.push_back({{here, right + around, here + around}});
        }
    makeMesh(mesh, points, faces);
}

/// Corners on the axes: valence 4 everywhere.
inline void makeOctahedron(NeuralMesh &mesh)
{
    makeMesh(mesh, {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
             {{{0, 2, 4}},
              {{2, 1, 4}},
              {{1, 3, 4}},
              {{3, 0, 4}},
              {{2, 0, 5}},
              {{1, 2, 5}},
              {{3, 1, 5}},
              {{0, 3, 5}}});
}

/// Two tetrahedra glued at a face, with apexes 3 (above) and 4 (below) of the triangle 0 1 2.
/// Its edges 0-1, 1-2 and 2-0 lie on a triangle that is no face.
inline void makeBipyramid(NeuralMesh &mesh)
{
    makeMesh(mesh, {{1, 0, 0}, {-0.5, 0.87, 0}, {-0.5, -0.87, 0}, {0, 0, 1}, {0, 0, -1}},
             {{{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}, {{1, 0, 4}}, {{2, 1, 4}}, {{0, 2, 4}}});
}

/// A torus of `major` by `minor` quads, each cut in two: valence 6 everywhere, genus 1.
inline void makeTorus(NeuralMesh &mesh, VertexId major, VertexId minor)
{
    std::vector<Point3> points;
    std::vector<Triangle> faces;
    for (VertexId i = 0; i < major; ++i)
        for (VertexId j = 0; j < minor; ++j) {
            const double a = 2 * M_PI * i / major;
            const double b = 2 * M_PI * j / minor;
            points.emplace_back((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a),
                                std::sin(b));
            const VertexId here = i * minor + j;
            const VertexId right = (i + 1) % major * minor + j;
            const VertexId up = i * minor + (j + 1) % minor;
            const VertexId both = (i + 1) % major * minor + (j + 1) % minor;
            faces.push_back({{here, right, both}});
            faces.push_back({{here, both, up}});
        }
    makeMesh(mesh, points, faces);
}

/// A torus of flat section, whose upper and lower sheet are closer to each other than the vertices,
/// and those of one lie over the middles of the other's faces.
inline void makeFlatTorus(NeuralMesh &mesh, VertexId major, VertexId minor)
{
    makeTorus(mesh, major, minor);
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        const double a = 2 * M_PI * (v / minor) / major;
        const double b = 2 * M_PI * (v % minor + 0.25) / minor;
        mesh.position(v) = {(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a),
                            0.05 * std::sin(b)};
    }
}

} // namespace neuralmesh::test
