// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/sheet_doubling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/self_intersections.h"
#include "core/network/growing_network.h"
#include "tests/meshes_for_tests.h"
#include "tests/ring_mutations.h"

namespace neuralmesh {
namespace {

/// Doubles all of the mesh, and compares with what the double of a surface is.
void expectDouble(NeuralMesh &mesh)
{
    const TopologyFigures before = measureTopology(mesh);
    int onBoundary = 0;
    forEachVertex(mesh, [&](VertexId v) { onBoundary += mesh.isOnBoundary(v) ? 1 : 0; });
    const std::vector<Doubled> doubled = doubleSheets(mesh, test::liveVertices(mesh));
    ASSERT_EQ(static_cast<int>(doubled.size()), before.vertices - onBoundary);
    ASSERT_NO_THROW(validate(mesh));
    const TopologyFigures after = measureTopology(mesh);
    EXPECT_EQ(after.boundaryLoops, 0);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.vertices, 2 * before.vertices - onBoundary);
    EXPECT_EQ(after.faces, 2 * before.faces);
    EXPECT_EQ(after.genus, 2 * before.genus + before.boundaryLoops - before.components);
    for (const auto &[front, back] : doubled)
        EXPECT_EQ(mesh.position(front), mesh.position(back));
}

TEST(SheetDoubling, a_square_becomes_a_sphere_of_two_sides)
{
    NeuralMesh mesh;
    for (const VertexId size : {2U, 3U, 8U}) {
        test::makeSquare(mesh, size);
        expectDouble(mesh);
    }
}

TEST(SheetDoubling, a_square_without_inner_vertices_becomes_a_tetrahedron)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 1);
    EXPECT_TRUE(doubleSheets(mesh, test::liveVertices(mesh)).empty());
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 0);
    EXPECT_EQ(mesh.vn, 4);
}

TEST(SheetDoubling, a_tube_becomes_a_torus)
{
    NeuralMesh mesh;
    test::makeTube(mesh, 5, 3);
    expectDouble(mesh);
}

TEST(SheetDoubling, a_single_triangle_stays)
{
    NeuralMesh mesh;
    test::makeMesh(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}});
    EXPECT_TRUE(doubleSheets(mesh, test::liveVertices(mesh)).empty());
    validate(mesh);
    EXPECT_EQ(mesh.vn, 3);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
}

TEST(SheetDoubling, meshes_after_random_operations_have_a_double)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 3);
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        test::mutate(mesh, random, 30);
        if (mesh.vn < 12)
            continue;
        NeuralMesh copy;
        copy.copyNetwork(mesh);
        expectDouble(copy);
    }
}

TEST(SheetDoubling, both_sides_keep_apart_over_ridges_and_valleys)
{
    // Corners whose diagonal joins two vertices of the boundary, folded up and down.
    for (const double fold : {-0.3, 0.3}) {
        NeuralMesh mesh;
        test::makeSquare(mesh, 6);
        forEachVertex(mesh, [&](VertexId v) {
            Point3 &p = mesh.position(v);
            p.Z() = fold * std::abs(p.X() + p.Y() - 6) + fold * std::abs(p.X() - p.Y());
        });
        Box3 bounds;
        forEachVertex(mesh, [&](VertexId v) { bounds.Add(mesh.position(v)); });
        GrowingNetwork network(mesh, bounds, GrowthParameters{});
        network.closeSheets(test::liveVertices(mesh));
        validate(mesh);
        EXPECT_TRUE(isClosed(mesh));
        EXPECT_EQ(findSelfIntersections(mesh).faces, 0) << "fold " << fold;
    }
}

TEST(OpenSheets, are_what_a_disc_over_the_boundary_would_close_badly)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 4);
    OpenSheets sheets(mesh);
    EXPECT_TRUE(sheets.isEmpty());
    EXPECT_EQ(sheets.copies(), 0);
    sheets.judge();
    EXPECT_FALSE(sheets.isEmpty());
    EXPECT_EQ(sheets.copies(), 9);
    EXPECT_EQ(sheets.vertices().size(), 25U);

    NeuralMesh tube; // its discs have a quarter of its area
    test::makeTube(tube, 12, 7);
    OpenSheets ofTube(tube);
    ofTube.judge();
    EXPECT_TRUE(ofTube.isEmpty());
}

TEST(OpenSheets, take_what_splits_make)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 4);
    OpenSheets sheets(mesh);
    sheets.judge();
    GrowingNetwork network(mesh, Box3({0, 0, 0}, {4, 4, 1}), GrowthParameters{});
    const VertexId onBoundary = network.splitBoundary(sheets.vertices());
    sheets.take(onBoundary);
    EXPECT_EQ(sheets.copiesOf(onBoundary), 0);
    EXPECT_EQ(sheets.copies(), 9);
    const VertexId v = network.splitMostActive();
    sheets.take(v);
    EXPECT_EQ(sheets.copies(), 9 + sheets.copiesOf(v));
    EXPECT_EQ(sheets.vertices().size(), 27U);
}

} // namespace
} // namespace neuralmesh
