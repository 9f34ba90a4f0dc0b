// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_checks.h"

#include <gtest/gtest.h>

#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

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
