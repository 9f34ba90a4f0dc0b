// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/neural_mesh.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/vertex_data.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

TEST(NeuralMesh, uses_the_slot_of_a_removed_vertex_again)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 5, 5);
    const VertexId bound = mesh.idBound();
    collapse(mesh, 7, mesh.ring(7)[0]);
    EXPECT_FALSE(mesh.isLive(7));
    EXPECT_EQ(mesh.addVertex({0, 0, 0}), 7U);
    EXPECT_EQ(mesh.addVertex({0, 0, 0}), bound);
    EXPECT_EQ(mesh.vn, static_cast<int>(bound) + 1);
}

TEST(NeuralMesh, adds_a_vertex_at_the_place_of_another_while_its_storage_grows)
{
    NeuralMesh mesh;
    const VertexId first = mesh.addVertex({1, 2, 3});
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(mesh.position(mesh.addVertex(mesh.position(first))), Point3(1, 2, 3));
}

TEST(NeuralMesh, a_copy_has_the_same_network_and_free_slots_of_its_own)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 5, 5);
    collapse(mesh, 7, mesh.ring(7)[0]);
    NeuralMesh copy;
    test::makeOctahedron(copy);
    copy.copyNetwork(mesh);
    validate(copy);
    EXPECT_EQ(copy.vn, 24);
    EXPECT_EQ(copy.addVertex({0, 0, 0}), 7U);
    EXPECT_FALSE(mesh.isLive(7));
}

TEST(NeuralMesh, keeps_its_network_and_no_free_slot_when_it_is_compacted)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 5, 5);
    collapse(mesh, 7, mesh.ring(7)[0]);
    const Point3 last = mesh.position(24);
    const Point3 neighbour = mesh.position(mesh.ring(24)[0]);
    mesh.compact();
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).genus, 1);
    EXPECT_EQ(mesh.vn, 24);
    EXPECT_EQ(mesh.idBound(), 24U);
    EXPECT_EQ(mesh.position(23), last);
    EXPECT_EQ(mesh.position(mesh.ring(23)[0]), neighbour);
    EXPECT_EQ(mesh.addVertex({0, 0, 0}), 24U);
}

TEST(NeuralMesh, forgets_its_free_slots_when_it_is_cleared)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 5, 5);
    collapse(mesh, 7, mesh.ring(7)[0]);
    mesh.Clear();
    EXPECT_EQ(mesh.addVertex({0, 0, 0}), 0U);
}

TEST(VertexData, follows_the_mesh_and_starts_anew_in_a_slot_that_is_used_again)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 5, 5);
    VertexData<int> data(mesh, -1);
    data[7] = 42;
    data[8] = 43;
    collapse(mesh, 7, mesh.ring(7)[0]);
    EXPECT_EQ(data[mesh.addVertex({0, 0, 0})], -1);
    EXPECT_EQ(data[mesh.addVertex({0, 0, 0})], -1);
    EXPECT_EQ(data[8], 43);
    data.reset();
    EXPECT_EQ(data[8], -1);
}

TEST(VertexData, no_longer_follows_when_it_is_gone)
{
    NeuralMesh mesh;
    VertexData<int> stays(mesh, 1);
    {
        const VertexData<int> goes(mesh);
    }
    EXPECT_EQ(stays[mesh.addVertex({0, 0, 0})], 1);
}

} // namespace
} // namespace neuralmesh
