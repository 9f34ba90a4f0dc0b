// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on rings at boundaries.
#include <gtest/gtest.h>

#include "core/mesh/boundary.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
#include "tests/meshes_for_tests.h"
#include "tests/ring_mutations.h"

namespace neuralmesh {
namespace {

using test::compareCollapsesWithVcg;
using test::makeSquare;
using test::makeTorus;
using test::makeTube;
using test::mutate;
using test::mutateAndValidate;

TEST(OpenRings, can_collapse_agrees_with_vcg_on_open_meshes)
{
    NeuralMesh mesh;
    for (const VertexId size : {1U, 2U, 3U}) {
        makeSquare(mesh, size);
        compareCollapsesWithVcg(mesh);
    }
    makeTube(mesh, 3, 1); // full of triangles around it that are no faces
    compareCollapsesWithVcg(mesh);
    makeTube(mesh, 5, 2);
    compareCollapsesWithVcg(mesh);
    test::makeMesh(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}); // a single triangle
    compareCollapsesWithVcg(mesh);
    EXPECT_FALSE(canCollapse(mesh, 0, 1));
}

TEST(OpenRings, a_split_along_the_boundary_makes_a_neighbour_on_it)
{
    // The last vertex of the lower side, and what it keeps and gives:
    //
    //     6---7---8
    //     | / | / |
    //     3---4---5
    //     | / | / |
    //     0---1---2
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    ASSERT_EQ(std::vector<VertexId>(mesh.ring(1).begin(), mesh.ring(1).end()),
              (std::vector<VertexId>{2, 5, 4, 0}));
    const VertexId after = mesh.addVertex({1.5, 0, 0});
    split(mesh, 1, gapPlace, 1, after); // takes 2 and 5, and shares 5
    validate(mesh);
    EXPECT_EQ(nextOnBoundary(mesh, 1), after);
    EXPECT_EQ(nextOnBoundary(mesh, after), 2U);
    EXPECT_EQ(mesh.valence(after), 3);
    EXPECT_EQ(mesh.valence(1), 4);

    const VertexId before = mesh.addVertex({0.5, 0, 0});
    split(mesh, 1, 2, gapPlace, before); // takes 4 and 0, and shares 4
    validate(mesh);
    EXPECT_EQ(previousOnBoundary(mesh, 1), before);
    EXPECT_EQ(previousOnBoundary(mesh, before), 0U);
    EXPECT_EQ(mesh.valence(before), 3);
    EXPECT_EQ(mesh.valence(1), 4);
    EXPECT_EQ(boundaryLoops(mesh).front().size(), 10U);

    ASSERT_TRUE(canCollapse(mesh, after, 1));
    collapse(mesh, after, 1);
    ASSERT_TRUE(canCollapse(mesh, before, 1));
    collapse(mesh, before, 1);
    validate(mesh);
    EXPECT_EQ(std::vector<VertexId>(mesh.ring(1).begin(), mesh.ring(1).end()),
              (std::vector<VertexId>{2, 5, 4, 0}));
}

TEST(OpenRings, a_boundary_vertex_that_is_split_into_the_surface_stays_on_the_boundary)
{
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    const VertexId w = mesh.addVertex({1, 0.5, 0});
    split(mesh, 1, 1, 3, w); // takes 5, 4 and 0
    validate(mesh);
    EXPECT_FALSE(mesh.isOnBoundary(w));
    EXPECT_EQ(mesh.valence(w), 4);
    EXPECT_EQ(std::vector<VertexId>(mesh.ring(1).begin(), mesh.ring(1).end()),
              (std::vector<VertexId>{2, 5, w, 0}));
}

TEST(OpenRings, a_collapse_into_the_surface_takes_the_boundary_with_it)
{
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    ASSERT_TRUE(canCollapse(mesh, 1, 4));
    collapse(mesh, 1, 4);
    validate(mesh);
    EXPECT_TRUE(mesh.isOnBoundary(4));
    EXPECT_EQ(nextOnBoundary(mesh, 4), 2U);
    EXPECT_EQ(previousOnBoundary(mesh, 4), 0U);
}

TEST(OpenRings, an_edge_between_two_boundary_vertices_may_collapse_only_along_the_boundary)
{
    NeuralMesh mesh;
    makeSquare(mesh, 1);
    EXPECT_FALSE(canCollapse(mesh, 0, 3)); // the diagonal: nothing would be left
    EXPECT_TRUE(canCollapse(mesh, 0, 1));
    makeTube(mesh, 5, 1);
    EXPECT_FALSE(canCollapse(mesh, 0, 5)); // from end to end of the tube: both would meet
    EXPECT_TRUE(canCollapse(mesh, 0, 1));
}

TEST(OpenRings, an_edge_of_the_boundary_does_not_flip)
{
    NeuralMesh mesh;
    makeSquare(mesh, 1);
    EXPECT_FALSE(canFlip(mesh, 0, 1));
    ASSERT_TRUE(canFlip(mesh, 0, 3)); // the diagonal, though both ends keep two neighbours only
    flip(mesh, 0, 3);
    validate(mesh);
    EXPECT_TRUE(mesh.ring(1).contains(2));
}

TEST(OpenRings, random_operations_keep_open_meshes_as_open_as_they_are)
{
    for (const std::uint64_t seed : {7U, 8U, 9U}) {
        NeuralMesh mesh;
        makeSquare(mesh, 1);
        mutateAndValidate(mesh, seed, 15000, 20);
        makeTube(mesh, 4, 1);
        mutateAndValidate(mesh, seed, 10000, 24);
        makeTorus(mesh, 5, 5);
        openDisc(mesh, {0, 5, 6, 1}, {});
        openDisc(mesh, {12, 17, 18, 13}, {});
        mutateAndValidate(mesh, seed, 10000, 40);
    }
}

TEST(OpenRings, can_collapse_agrees_with_vcg_on_open_meshes_after_random_operations)
{
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    Random random(11);
    for (int i = 0; i < 400; ++i) {
        mutate(mesh, random, 16);
        NeuralMesh compact;
        compact.copyNetwork(mesh);
        compareCollapsesWithVcg(compact);
    }
}

} // namespace
} // namespace neuralmesh
