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

/// Builds the rings of a closed oriented mesh from its faces.
inline void makeMesh(NeuralMesh &mesh, const std::vector<Point3> &points,
                     const std::vector<Triangle> &faces)
{
    mesh.Clear();
    for (const Point3 &point : points)
        mesh.addVertex(point);
    for (VertexId v = 0; v < points.size(); ++v) {
        // successor[a] = b for each face (v, a, b)
        std::vector<VertexId> successor(points.size(), noVertex);
        VertexId first = noVertex;
        for (const Triangle &face : faces)
            for (std::size_t corner = 0; corner < 3; ++corner)
                if (face[corner] == v) {
                    first = face[(corner + 1) % 3];
                    successor[first] = face[(corner + 2) % 3];
                }
        for (VertexId a = first; mesh.valence(v) == 0 || a != first; a = successor[a])
            mesh.ring(v).pushBack(a);
    }
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

} // namespace neuralmesh::test
