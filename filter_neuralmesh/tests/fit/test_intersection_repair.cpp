// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/intersection_repair.h"

#include <gtest/gtest.h>

#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

Box3 wideBounds()
{
    Box3 bounds;
    bounds.Add(Point3(-5, -5, -5));
    bounds.Add(Point3(5, 5, 5));
    return bounds;
}

std::vector<Point3> positionsOf(const NeuralMesh &mesh)
{
    std::vector<Point3> positions;
    for (const NeuralVertex &vertex : mesh.vert)
        positions.push_back(vertex.cP());
    return positions;
}

TEST(IntersectionRepair, a_vertex_pushed_through_the_opposite_wall_comes_back)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    const std::vector<Point3> before = positionsOf(mesh);
    network.moveVertex(0, before[0] - Point3(2.5, 0, 0)); // from the outside through the tube
    ASSERT_FALSE(network.findIntersectingVertices().empty());
    EXPECT_EQ(repairIntersections(network, before), 0);
    EXPECT_TRUE(network.findIntersectingVertices().empty());
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        EXPECT_TRUE(v == 0 || mesh.position(v) == before[v]) << v; // the wall was sound
}

TEST(IntersectionRepair, what_intersected_before_too_is_smoothed)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    network.moveVertex(0, mesh.position(0) - Point3(2.5, 0, 0));
    const std::vector<Point3> before = positionsOf(mesh);
    EXPECT_EQ(repairIntersections(network, before), 0);
    EXPECT_TRUE(network.findIntersectingVertices().empty());
}

TEST(IntersectionRepair, a_sound_mesh_stays_as_it_is)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    const std::vector<Point3> before = positionsOf(mesh);
    const std::vector<Point3> elsewhere(before.size(), Point3(0, 0, 0));
    EXPECT_EQ(repairIntersections(network, elsewhere), 0);
    EXPECT_EQ(positionsOf(mesh), before);
}

} // namespace
} // namespace neuralmesh
