// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/census.h"

#include <gtest/gtest.h>

#include "core/mesh/enumeration.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

TEST(Census, corners_of_crossing_faces_are_misplaced_though_they_win)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 24, 12);
    Box3 bounds;
    bounds.Add(Point3(-5, -5, -5));
    bounds.Add(Point3(5, 5, 5));
    GrowingNetwork network(mesh, bounds, GrowthParameters{});
    std::vector<Point3> samples;
    const auto sampleEachVertex = [&] {
        samples.clear();
        forEachVertex(mesh, [&](VertexId v) { samples.push_back(mesh.position(v)); });
    };
    const Census census(network.vertexCount(), 100'000);
    sampleEachVertex();
    EXPECT_TRUE(census.misplaced(network, samples).empty());

    network.moveVertex(0, mesh.position(0) - Point3(2.5, 0, 0)); // from outside through the tube
    sampleEachVertex();
    const std::vector<VertexId> found = census.misplaced(network, samples);
    EXPECT_EQ(found, network.findSelfIntersections().corners);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front(), 0U);
}

} // namespace
} // namespace neuralmesh
