// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/plain_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "neuralmesh/errors.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

using Problem = InvalidStartingMesh::Problem;

const Mesh tetrahedron{{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}},
                       {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};

const UnitFrame shifted({{{99, 99, 99}}, {{101, 101, 101}}});

Problem refusal(const Mesh &mesh, std::uint64_t count)
{
    NeuralMesh network;
    try {
        makeNetwork(network, mesh, shifted);
    } catch (const InvalidStartingMesh &error) {
        EXPECT_EQ(error.count(), count);
        return error.problem();
    }
    ADD_FAILURE() << "accepted";
    return Problem::missing;
}

TEST(PlainMesh, leaves_out_the_slots_of_removed_vertices)
{
    NeuralMesh network;
    test::makeTorus(network, 8, 6);
    const Point3 kept = network.position(4);
    collapse(network, 3, network.ring(3)[0]);
    rebuildFaces(network);
    const Mesh mesh = plainMesh(network, UnitFrame());
    ASSERT_EQ(mesh.positions.size(), 47U);
    EXPECT_EQ(mesh.triangles.size(), 94U);
    EXPECT_EQ(mesh.positions[3], toPlain(kept));
    for (const Corners &face : mesh.triangles)
        for (const VertexId v : face)
            EXPECT_LT(v, 47U);
}

TEST(PlainMesh, comes_back_from_the_network_in_world_coordinates)
{
    NeuralMesh network;
    makeNetwork(network, tetrahedron, shifted);
    EXPECT_NEAR(network.position(0).X(), -100 / (2 * std::sqrt(3)), 1e-12);
    rebuildFaces(network);
    const Mesh mesh = plainMesh(network, shifted);
    ASSERT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.triangles.size(), 4U);
    // In the order in which faces name them.
    EXPECT_NEAR(mesh.positions[1][1], 1, 1e-12);
    EXPECT_NEAR(mesh.positions[2][0], 1, 1e-12);
}

TEST(PlainMesh, no_network_is_made_of_numbers_that_mean_nothing)
{
    Mesh mesh = tetrahedron;
    mesh.positions[2][1] = std::nan("");
    EXPECT_EQ(refusal(mesh, 0), Problem::notFinite);
    mesh = tetrahedron;
    mesh.triangles[1][0] = 4;
    mesh.triangles[3][2] = 0xffffffffU;
    EXPECT_EQ(refusal(mesh, 2), Problem::unknownVertex);
    mesh = tetrahedron;
    mesh.triangles.pop_back();
    EXPECT_EQ(refusal(mesh, 3), Problem::openEdge);
}

} // namespace
} // namespace neuralmesh
