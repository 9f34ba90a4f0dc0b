// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary.h"
#include "core/mesh/mesh_checks.h"

#include <gtest/gtest.h>

#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

TEST(MeshChecks, count_open_meshes)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 3);
    EXPECT_EQ(measureTopology(mesh).vertices, 16);
    EXPECT_EQ(measureTopology(mesh).edges, 33);
    EXPECT_EQ(measureTopology(mesh).faces, 18);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
    EXPECT_EQ(measureTopology(mesh).genus, 0);
    test::makeTube(mesh, 5, 3);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 2);
    EXPECT_EQ(measureTopology(mesh).genus, 0);
    EXPECT_EQ(measureTopology(mesh).components, 1);
}

TEST(MeshChecks, walk_a_boundary_with_the_surface_to_the_left)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 2);
    EXPECT_EQ(boundaryLoops(mesh), (std::vector<std::vector<VertexId>>{{0, 1, 2, 5, 8, 7, 6, 3}}));
    EXPECT_FALSE(isClosed(mesh));
    test::makeTorus(mesh, 4, 4);
    EXPECT_TRUE(boundaryLoops(mesh).empty());
    EXPECT_TRUE(isClosed(mesh));
}

TEST(MeshChecks, find_a_boundary_on_which_two_vertices_do_not_agree)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 2);
    ASSERT_EQ(findDefect(mesh), "");
    mesh.ring(1).rotate(1); // the gap is elsewhere now
    EXPECT_NE(findDefect(mesh), "");
    test::makeSquare(mesh, 2);
    mesh.ring(1).setOpen(false);
    EXPECT_NE(findDefect(mesh), "");
}

TEST(MeshChecks, count_a_torus)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 5, 4);
    const TopologyFigures figures = measureTopology(mesh);
    EXPECT_EQ(figures.vertices, 20);
    EXPECT_EQ(figures.edges, 60);
    EXPECT_EQ(figures.faces, 40);
    EXPECT_EQ(figures.components, 1);
    EXPECT_EQ(figures.genus, 1);
    EXPECT_EQ(valenceHistogram(mesh), (std::vector<int>{0, 0, 0, 0, 0, 0, 20}));
}

TEST(MeshChecks, find_a_ring_that_is_not_mutual)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    EXPECT_EQ(findDefect(mesh), "");
    mesh.ring(0).erase(1);
    EXPECT_NE(findDefect(mesh), "");
    EXPECT_THROW(validate(mesh), std::logic_error);
}

TEST(MeshChecks, find_a_ring_in_the_wrong_order)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    const VertexId first = mesh.ring(0)[0];
    mesh.ring(0).set(0, mesh.ring(0)[1]);
    mesh.ring(0).set(1, first);
    EXPECT_NE(findDefect(mesh), "");
}

TEST(MeshChecks, find_a_repeated_neighbour_and_a_removed_one)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    mesh.ring(0).set(0, mesh.ring(0)[1]);
    EXPECT_EQ(findDefect(mesh).substr(0, 12), "a ring names");
    test::makeOctahedron(mesh);
    mesh.vert[3].SetD();
    EXPECT_NE(findDefect(mesh), "");
}

} // namespace
} // namespace neuralmesh
