// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_surgery.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/boundary.h"
#include "core/mesh/mesh_checks.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

TEST(RingSurgery, a_disc_that_is_opened_leaves_a_hole_and_filling_it_brings_the_mesh_back)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 6, 6);
    const std::vector<VertexId> rim(mesh.ring(14).begin(), mesh.ring(14).end());
    ASSERT_TRUE(canOpenDisc(mesh, rim));
    openDisc(mesh, rim, {14});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(mesh.vn, 35);
    const TopologyFigures open = measureTopology(mesh);
    EXPECT_EQ(open.boundaryLoops, 1);
    EXPECT_EQ(open.genus, 1);
    EXPECT_EQ(open.faces, 72 - 6);
    // The hole's rim is the boundary walked backwards.
    std::vector<VertexId> hole = boundaryLoops(mesh).front();
    std::reverse(hole.begin(), hole.end());
    refillDisc(mesh, hole, {}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 0);
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

TEST(RingSurgery, a_disc_at_the_boundary_is_filled_anew)
{
    // The two faces of a corner's quad get the other diagonal.
    NeuralMesh mesh;
    test::makeSquare(mesh, 2);
    refillDisc(mesh, {0, 1, 4, 3}, {}, {{0, 1, 3}, {1, 2, 3}});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_FALSE(mesh.ring(0).contains(4));
    EXPECT_TRUE(mesh.ring(1).contains(3));
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
}

TEST(RingSurgery, a_disc_that_touches_a_boundary_is_not_opened)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 3);
    EXPECT_TRUE(canOpenDisc(mesh, {5, 6, 10, 9})); // the quad in the middle
    EXPECT_FALSE(canOpenDisc(mesh, {0, 1, 5, 4}));
    openDisc(mesh, {5, 6, 10, 9}, {});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 2);
}

} // namespace
} // namespace neuralmesh
