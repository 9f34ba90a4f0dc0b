// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/manifold_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "neuralmesh/errors.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

using Points = std::vector<Point3>;
using Faces = std::vector<Corners>;

const Points corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
const Faces tetrahedron{{{0, 1, 2}}, {{0, 3, 1}}, {{0, 2, 3}}, {{1, 3, 2}}};

std::string refusal(const Points &points, const Faces &faces)
{
    NeuralMesh mesh;
    try {
        makeManifold(mesh, points, faces);
    } catch (const InvalidInput &error) {
        return error.what();
    }
    return "accepted";
}

void append(Points &points, Faces &faces, const Point3 &offset)
{
    const auto first = static_cast<VertexId>(points.size());
    for (const Point3 &p : corners)
        points.push_back(p + offset);
    for (const Corners &f : tetrahedron)
        faces.push_back({{f[0] + first, f[1] + first, f[2] + first}});
}

/// A closed grid of quads: the second seam is glued straight (a torus) or reversed (a Klein
/// bottle).
void gluedGrid(VertexId size, bool isReversed, Points &points, Faces &faces)
{
    const auto at = [&](VertexId i, VertexId j) {
        if (i == size && isReversed)
            j = 2 * size - j;
        return i % size * size + j % size;
    };
    for (VertexId i = 0; i < size; ++i)
        for (VertexId j = 0; j < size; ++j) {
            points.emplace_back(i, j, 0);
            faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
            faces.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
        }
}

TEST(ManifoldMesh, makes_the_rings_of_a_torus_from_its_faces)
{
    NeuralMesh torus;
    test::makeTorus(torus, 12, 8);
    rebuildFaces(torus);
    Points points;
    Faces faces;
    for (const NeuralVertex &vertex : torus.vert)
        points.push_back(vertex.cP());
    for (const NeuralFace &face : torus.face) {
        Corners f;
        for (int c = 0; c < 3; ++c)
            f[static_cast<std::size_t>(c)] =
                static_cast<VertexId>(vcg::tri::Index(torus, face.cV(c)));
        faces.push_back(f);
    }
    NeuralMesh mesh;
    makeManifold(mesh, points, faces);
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.vertices, 96);
    EXPECT_EQ(topology.faces, 192);
    EXPECT_EQ(topology.genus, 1);
    EXPECT_DOUBLE_EQ(signedVolume(mesh), signedVolume(torus));
}

TEST(ManifoldMesh, leaves_out_points_that_no_face_names)
{
    Points points{{9, 9, 9}};
    Faces faces;
    append(points, faces, {0, 0, 0});
    points.emplace_back(7, 7, 7);
    NeuralMesh mesh;
    makeManifold(mesh, points, faces);
    validate(mesh);
    EXPECT_EQ(mesh.vn, 4);
}

TEST(ManifoldMesh, takes_several_components_and_counts_their_genera)
{
    Points points;
    Faces faces;
    gluedGrid(4, false, points, faces);
    append(points, faces, {10, 0, 0});
    append(points, faces, {20, 0, 0});
    NeuralMesh mesh;
    makeManifold(mesh, points, faces);
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).components, 3);
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

TEST(ManifoldMesh, turns_faces_that_do_not_agree_outwards_and_keeps_those_that_do)
{
    Faces mixed = tetrahedron;
    std::swap(mixed[1][1], mixed[1][2]);
    std::swap(mixed[2][1], mixed[2][2]);
    NeuralMesh mesh;
    makeManifold(mesh, corners, mixed);
    validate(mesh);
    EXPECT_DOUBLE_EQ(signedVolume(mesh), 8.0 / 3); // a third of a cube of edge 2

    Faces insideOut = tetrahedron; // a cavity
    for (Corners &f : insideOut)
        std::swap(f[1], f[2]);
    makeManifold(mesh, corners, insideOut);
    validate(mesh);
    EXPECT_DOUBLE_EQ(signedVolume(mesh), -8.0 / 3);
}

TEST(ManifoldMesh, refuses_open_surfaces)
{
    EXPECT_EQ(refusal(corners, {}), "The starting mesh has no faces.");
    EXPECT_EQ(refusal(corners, {tetrahedron.begin(), tetrahedron.end() - 1}),
              "The starting mesh is not closed: 3 edges belong to one face only. Close its holes, "
              "or merge its close vertices.");
}

TEST(ManifoldMesh, takes_open_surfaces_where_boundaries_are_allowed)
{
    Points points;
    Faces faces;
    append(points, faces, {0, 0, 0}); // a closed component beside
    const VertexId first = 4;
    for (VertexId j = 0; j <= 2; ++j)
        for (VertexId i = 0; i <= 2; ++i)
            points.emplace_back(i, j, 9);
    for (VertexId j = 0; j < 2; ++j)
        for (VertexId i = 0; i < 2; ++i) {
            const VertexId here = first + 3 * j + i;
            // Downwards, against what a volume would say.
            faces.push_back({{here, here + 4, here + 1}});
            faces.push_back({{here, here + 3, here + 4}});
        }
    NeuralMesh mesh;
    makeManifold(mesh, points, faces, Boundaries::allowed);
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.components, 2);
    EXPECT_EQ(topology.boundaryLoops, 1);
    EXPECT_EQ(topology.genus, 0);
    EXPECT_EQ(topology.faces, 12);
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        const Point3 normal =
            (mesh.position(b) - mesh.position(a)) ^ (mesh.position(c) - mesh.position(a));
        EXPECT_TRUE(mesh.position(a).Z() < 8 || normal.Z() < 0);
    });
}

TEST(ManifoldMesh, turns_the_faces_of_an_open_surface_like_the_first)
{
    const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    NeuralMesh mesh;
    makeManifold(mesh, points, {{{0, 2, 1}}, {{1, 3, 2}}}, Boundaries::allowed); // down and up
    validate(mesh);
    EXPECT_EQ(boundaryLoops(mesh).front(), (std::vector<VertexId>{0, 1, 3, 2})); // as it was given
}

TEST(ManifoldMesh, refuses_two_open_fans_at_one_vertex)
{
    const Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
    NeuralMesh mesh;
    EXPECT_THROW(makeManifold(mesh, points, {{{0, 1, 2}}, {{0, 3, 4}}}, Boundaries::allowed),
                 InvalidStartingMesh);
}

TEST(ManifoldMesh, refuses_what_is_no_two_manifold)
{
    Faces twice = tetrahedron;
    twice.push_back({{0, 0, 1}});
    EXPECT_EQ(refusal(corners, twice),
              "The starting mesh is not two-manifold: 1 face names a vertex twice.");

    Points points = corners; // two tetrahedra that share an edge
    points.emplace_back(3, 0, 1);
    points.emplace_back(3, 0, -1);
    Faces sharedEdge = tetrahedron;
    for (const Corners &f : Faces{{{0, 1, 4}}, {{0, 5, 1}}, {{0, 4, 5}}, {{1, 5, 4}}})
        sharedEdge.push_back(f);
    EXPECT_EQ(refusal(points, sharedEdge), "The starting mesh is not two-manifold: 1 edge belongs "
                                           "to more than two faces.");

    points = corners; // two tetrahedra that share a vertex
    Faces sharedVertex = tetrahedron;
    append(points, sharedVertex, {2, 2, 2});
    for (Corners &f : sharedVertex)
        std::replace(f.begin(), f.end(), VertexId(7), VertexId(0));
    EXPECT_EQ(refusal(points, sharedVertex), "The starting mesh is not two-manifold: several fans "
                                             "of faces meet at one vertex.");

    EXPECT_EQ(refusal(corners, {{{0, 1, 2}}, {{0, 2, 1}}}),
              "The starting mesh is not two-manifold: two faces have the same three vertices.");
}

TEST(ManifoldMesh, refuses_a_klein_bottle)
{
    Points points;
    Faces faces;
    gluedGrid(5, true, points, faces);
    EXPECT_EQ(refusal(points, faces),
              "The starting mesh is not orientable: its faces have no common outside.");
}

} // namespace
} // namespace neuralmesh
