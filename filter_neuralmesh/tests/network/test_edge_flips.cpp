// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/edge_flips.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

int valenceSpread(const NeuralMesh &mesh)
{
    int sum = 0;
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        sum += (mesh.valence(v) - 6) * (mesh.valence(v) - 6);
    return sum;
}

TEST(EdgeFlips, valence_gain_is_what_the_sum_of_squares_loses)
{
    Random random(1);
    NeuralMesh mesh;
    test::makeTorus(mesh, 6, 6);
    for (int i = 0; i < 500; ++i) {
        const auto v = static_cast<VertexId>(random.below(36));
        const VertexId u = mesh.ring(
            v)[static_cast<int>(random.below(static_cast<std::uint64_t>(mesh.valence(v))))];
        if (!canFlip(mesh, v, u))
            continue;
        const int gain = valenceGain(mesh, v, u);
        const int before = valenceSpread(mesh);
        flip(mesh, v, u);
        EXPECT_EQ(before - valenceSpread(mesh), gain);
    }
}

TEST(EdgeFlips, undo_a_flip_that_spoiled_a_regular_flat_part)
{
    // The outer equator of a fine torus is nearly flat.
    NeuralMesh mesh;
    test::makeTorus(mesh, 48, 24);
    const VertexId v = 5 * 24;
    flip(mesh, v, v + 24);
    EXPECT_EQ(valenceSpread(mesh), 4);
    EXPECT_EQ(evenValencesAround(mesh, v), 1);
    validate(mesh);
    EXPECT_EQ(valenceSpread(mesh), 0);
}

TEST(EdgeFlips, refuse_to_cut_across_a_crease)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    EXPECT_TRUE(canFlip(mesh, 0, 2));
    EXPECT_FALSE(flipKeepsSurface(mesh, 0, 2)); // its faces turn by 70 degrees
}

TEST(EdgeFlips, refuse_a_flip_that_turns_a_face_over)
{
    // Vertex 3 of the quad 0 1 2 3 lies inside the triangle of the others: only one diagonal of
    // the two is inside the quad.
    NeuralMesh mesh;
    test::makeMesh(mesh, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, -3}},
                   {{{0, 1, 3}}, {{3, 1, 2}}, {{0, 3, 2}}, {{1, 0, 4}}, {{2, 1, 4}}, {{0, 2, 4}}});
    validate(mesh);
    EXPECT_FALSE(flipKeepsSurface(mesh, 3, 1));
}

} // namespace
} // namespace neuralmesh
