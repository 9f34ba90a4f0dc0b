// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_topology.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/meshes_for_tests.h"
#include "tests/ring_mutations.h"

namespace neuralmesh {
namespace {

using test::compareCollapsesWithVcg;
using test::liveVertices;
using test::makeBipyramid;
using test::makeOctahedron;
using test::makeTorus;
using test::mutateAndValidate;

TEST(RingTopology, a_tetrahedron_points_outwards_and_is_closed)
{
    NeuralMesh mesh;
    makeTetrahedron(mesh, {1, 2, 3}, 2);
    validate(mesh);
    // Edge 2 r sqrt(2/3), volume edge^3 / (6 sqrt 2) = r^3 8 sqrt(3) / 27.
    EXPECT_NEAR(signedVolume(mesh), 8 * 8 * std::sqrt(3.0) / 27, 1e-12);
}

TEST(RingTopology, can_collapse_refuses_every_edge_of_a_tetrahedron)
{
    NeuralMesh mesh;
    makeTetrahedron(mesh, {0, 0, 0}, 1);
    for (const VertexId v : liveVertices(mesh))
        for (const VertexId u : mesh.ring(v))
            EXPECT_FALSE(canCollapse(mesh, v, u));
    compareCollapsesWithVcg(mesh);
}

TEST(RingTopology, can_collapse_leaves_each_component_a_tetrahedron)
{
    NeuralMesh mesh;
    test::makeMesh(mesh,
                   {{1, 1, 1},
                    {1, -1, -1},
                    {-1, 1, -1},
                    {-1, -1, 1},
                    {9, 1, 1},
                    {9, -1, -1},
                    {7, 1, -1},
                    {7, -1, 1}},
                   {{{0, 1, 2}},
                    {{0, 3, 1}},
                    {{0, 2, 3}},
                    {{1, 3, 2}},
                    {{4, 5, 6}},
                    {{4, 7, 5}},
                    {{4, 6, 7}},
                    {{5, 7, 6}}});
    for (const VertexId v : liveVertices(mesh))
        for (const VertexId u : mesh.ring(v))
            EXPECT_FALSE(canCollapse(mesh, v, u));
    compareCollapsesWithVcg(mesh);
}

TEST(RingTopology, can_collapse_agrees_with_vcg_on_small_meshes)
{
    NeuralMesh mesh;
    makeBipyramid(mesh);
    EXPECT_FALSE(canCollapse(mesh, 0, 1)); // 0 1 2 is a triangle but no face
    EXPECT_TRUE(canCollapse(mesh, 0, 3));
    compareCollapsesWithVcg(mesh);
    makeOctahedron(mesh);
    compareCollapsesWithVcg(mesh);
    makeTorus(mesh, 3, 3); // full of triangles around the tube that are no faces
    compareCollapsesWithVcg(mesh);
    makeTorus(mesh, 4, 5);
    compareCollapsesWithVcg(mesh);
}

TEST(RingTopology, a_split_gives_both_vertices_the_promised_valences)
{
    NeuralMesh mesh;
    makeOctahedron(mesh);
    const VertexId w = mesh.addVertex({2, 0, 0});
    split(mesh, 0, 1, 3, w); // half of the star of a vertex of valence 4
    validate(mesh);
    EXPECT_EQ(mesh.valence(w), 4);
    EXPECT_EQ(mesh.valence(0), 4);
    EXPECT_EQ(measureTopology(mesh).genus, 0);
}

TEST(RingTopology, a_collapse_undoes_a_split)
{
    NeuralMesh mesh;
    makeTorus(mesh, 4, 4);
    std::vector<std::set<VertexId>> before;
    for (VertexId v = 0; v < 16; ++v)
        before.emplace_back(mesh.ring(v).begin(), mesh.ring(v).end());
    const VertexId w = mesh.addVertex({0, 0, 0});
    split(mesh, 5, 4, 1, w); // across the ring's first place
    validate(mesh);
    ASSERT_TRUE(canCollapse(mesh, w, 5));
    collapse(mesh, w, 5);
    validate(mesh);
    for (VertexId v = 0; v < 16; ++v)
        EXPECT_EQ(std::set<VertexId>(mesh.ring(v).begin(), mesh.ring(v).end()), before[v]);
    EXPECT_EQ(mesh.addVertex({0, 0, 0}), w); // the slot is used again
}

TEST(RingTopology, a_flip_turns_the_edge_and_flipping_again_turns_it_back)
{
    NeuralMesh mesh;
    makeTorus(mesh, 5, 5);
    const VertexId u = mesh.ring(7)[2];
    const OppositeVertices opposite = oppositeVertices(mesh, 7, u);
    ASSERT_TRUE(canFlip(mesh, 7, u));
    flip(mesh, 7, u);
    validate(mesh);
    EXPECT_FALSE(mesh.ring(7).contains(u));
    EXPECT_TRUE(mesh.ring(opposite.left).contains(opposite.right));
    ASSERT_TRUE(canFlip(mesh, opposite.left, opposite.right));
    flip(mesh, opposite.left, opposite.right);
    validate(mesh);
    EXPECT_TRUE(mesh.ring(7).contains(u));
}

TEST(RingTopology, can_flip_refuses_what_would_double_an_edge_or_leave_two_neighbours)
{
    NeuralMesh mesh;
    makeBipyramid(mesh);
    EXPECT_FALSE(canFlip(mesh, 0, 3)); // vertex 3 has valence 3
    EXPECT_TRUE(canFlip(mesh, 0, 1));  // becomes 3-4
    flip(mesh, 0, 1);
    validate(mesh);
    EXPECT_FALSE(canFlip(mesh, 0, 2)); // vertex 0 has lost a neighbour: valence 3
    makeOctahedron(mesh);
    EXPECT_TRUE(canFlip(mesh, 0, 2)); // becomes 4-5
    flip(mesh, 0, 2);
    validate(mesh);
    EXPECT_FALSE(canFlip(mesh, 1, 3)); // 4 and 5 are neighbours already
    makeTetrahedron(mesh, {0, 0, 0}, 1);
    EXPECT_FALSE(canFlip(mesh, 0, 1));
}

TEST(RingTopology, faces_are_those_of_the_rings)
{
    NeuralMesh mesh;
    makeTorus(mesh, 4, 5);
    rebuildFaces(mesh);
    EXPECT_EQ(mesh.fn, 40);
    vcg::tri::UpdateTopology<NeuralMesh>::FaceFace(mesh);
    EXPECT_TRUE(vcg::tri::Clean<NeuralMesh>::IsWaterTight(mesh));
    EXPECT_TRUE(vcg::tri::Clean<NeuralMesh>::IsCoherentlyOrientedMesh(mesh));
}

TEST(RingTopology, turning_round_changes_the_sign_of_the_volume)
{
    NeuralMesh mesh;
    makeTorus(mesh, 8, 8);
    const double volume = signedVolume(mesh);
    EXPECT_GT(volume, 0);
    reverseOrientation(mesh);
    validate(mesh);
    EXPECT_DOUBLE_EQ(signedVolume(mesh), -volume);
}

TEST(RingTopology, random_operations_keep_a_sphere_a_sphere)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        NeuralMesh mesh;
        makeTetrahedron(mesh, {0, 0, 0}, 1);
        mutateAndValidate(mesh, seed, 25000, 24); // small: every refusal is met often
    }
    NeuralMesh mesh;
    makeOctahedron(mesh);
    mutateAndValidate(mesh, 4, 15000, 60);
}

TEST(RingTopology, random_operations_keep_a_torus_a_torus)
{
    for (const std::uint64_t seed : {5U, 6U}) {
        NeuralMesh mesh;
        makeTorus(mesh, 4, 4);
        mutateAndValidate(mesh, seed, 15000, 40);
    }
}

} // namespace
} // namespace neuralmesh
