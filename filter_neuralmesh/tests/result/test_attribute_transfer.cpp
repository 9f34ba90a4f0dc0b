// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/attribute_transfer.h"

#include <gtest/gtest.h>

#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

Box3 boundsOf(const NeuralMesh &mesh)
{
    Box3 bounds;
    for (const NeuralVertex &vertex : mesh.vert)
        bounds.Add(vertex.cP());
    return bounds;
}

TEST(AttributeTransfer, a_vertex_has_the_mean_of_its_points)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    AttributeTransfer transfer(mesh, boundsOf(mesh));
    // Symmetric about vertex 0, so that both count the same.
    transfer.add({1, 0.1, 0}, {10, 0, 0, 255, 1});
    transfer.add({1, -0.1, 0}, {30, 0, 0, 255, 3});
    const std::vector<AttributeValues> found = transfer.average();
    EXPECT_EQ(found[0], (AttributeValues{20, 0, 0, 255, 2}));
}

TEST(AttributeTransfer, vertices_without_points_take_what_their_neighbours_have)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    AttributeTransfer transfer(mesh, boundsOf(mesh));
    transfer.add({1, 0, 0}, {8, 0, 0, 255, 0.5});
    for (const AttributeValues &values : transfer.average()) // vertex 1 is two edges away
        EXPECT_EQ(values, (AttributeValues{8, 0, 0, 255, 0.5}));
}

TEST(AttributeTransfer, a_point_far_off_colours_next_to_nothing)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    AttributeTransfer transfer(mesh, boundsOf(mesh));
    for (int i = 0; i < 10; ++i)
        transfer.add({1, 0, 0}, {100, 0, 0, 255, 0});
    transfer.add({20, 0, 0}, {0, 0, 0, 255, 0}); // 13 edges away: its weight is 1 / 32,000
    EXPECT_NEAR(transfer.average()[0][0], 100, 0.01);
}

TEST(AttributeTransfer, values_come_in_order_of_live_vertices)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 8, 6);
    collapse(mesh, 3, mesh.ring(3)[0]);
    AttributeTransfer transfer(mesh, boundsOf(mesh));
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        if (mesh.isLive(v))
            transfer.add(mesh.position(v), {0, 0, 0, 255, static_cast<double>(v)});
    const std::vector<AttributeValues> found = transfer.average();
    ASSERT_EQ(found.size(), 47U);
    EXPECT_EQ(found[2][4], 2);
    EXPECT_EQ(found[3][4], 4);
}

} // namespace
} // namespace neuralmesh
