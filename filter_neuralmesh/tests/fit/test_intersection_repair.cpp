// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/intersection_repair.h"

#include <gtest/gtest.h>

#include "core/mesh/enumeration.h"
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

void keepPositions(const NeuralMesh &mesh, VertexData<Point3> &positions)
{
    forEachVertex(mesh, [&](VertexId v) { positions[v] = mesh.position(v); });
}

TEST(IntersectionRepair, a_vertex_pushed_through_the_opposite_wall_comes_back)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    VertexData<Point3> before(mesh);
    keepPositions(mesh, before);
    network.moveVertex(0, before[0] - Point3(2.5, 0, 0)); // from the outside through the tube
    ASSERT_FALSE(network.findSelfIntersections().corners.empty());
    EXPECT_EQ(repairIntersections(network, before), 0);
    EXPECT_TRUE(network.findSelfIntersections().corners.empty());
    forEachVertex(mesh, [&](VertexId v) {
        EXPECT_TRUE(v == 0 || mesh.position(v) == before[v]) << v; // the wall was sound
    });
}

TEST(IntersectionRepair, what_intersected_before_too_is_smoothed)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    network.moveVertex(0, mesh.position(0) - Point3(2.5, 0, 0));
    VertexData<Point3> before(mesh);
    keepPositions(mesh, before);
    EXPECT_EQ(repairIntersections(network, before), 0);
    EXPECT_TRUE(network.findSelfIntersections().corners.empty());
}

TEST(IntersectionRepair, says_how_much_it_could_not_repair)
{
    // Two tori through each other, which no smoothing of some vertices parts.
    NeuralMesh one;
    test::makeTorus(one, 24, 12);
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    for (const VertexId k : {0U, 1U}) {
        for (const NeuralVertex &vertex : one.vert)
            points.push_back(vertex.cP() + Point3(k, 0, 0));
        forEachFace(one, [&](VertexId a, VertexId b, VertexId c) {
            const VertexId first = k * one.idBound();
            faces.push_back({a + first, b + first, c + first});
        });
    }
    NeuralMesh mesh;
    test::makeMesh(mesh, points, faces);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    VertexData<Point3> before(mesh);
    keepPositions(mesh, before);
    const int left = repairIntersections(network, before);
    EXPECT_GT(left, 0);
    EXPECT_EQ(left, network.findSelfIntersections().faces);
}

TEST(IntersectionRepair, a_sound_mesh_stays_as_it_is)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    VertexData<Point3> before(mesh);
    keepPositions(mesh, before);
    const VertexData<Point3> elsewhere(mesh, Point3(0, 0, 0));
    EXPECT_EQ(repairIntersections(network, elsewhere), 0);
    forEachVertex(mesh, [&](VertexId v) { EXPECT_EQ(mesh.position(v), before[v]) << v; });
}

} // namespace
} // namespace neuralmesh
