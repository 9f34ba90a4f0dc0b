// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/tear_mending.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "tests/torn_post_for_tests.h"

namespace neuralmesh {
namespace {

using namespace test;

struct Changes : VertexFollower {
    std::vector<VertexId> added, removed;

    void vertexAdded(VertexId v) override { added.push_back(v); }
    void vertexRemoved(VertexId v) override { removed.push_back(v); }
};

TEST(TearMending, a_torn_post_becomes_whole_and_loses_its_strand)
{
    NeuralMesh mesh;
    makeTornPost(mesh);
    ASSERT_EQ(findDefect(mesh), "");
    ASSERT_EQ(measureTopology(mesh).genus, 0);
    Changes changes;
    mesh.follow(changes);
    ASSERT_TRUE(mendTear(mesh, supportOfPost(true), 1000));
    mesh.unfollow(changes);
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).genus, 0);
    EXPECT_EQ(measureTopology(mesh).components, 1);
    // The middles of both stumps are gone, and the strand, three wide, is cut through once.
    EXPECT_EQ(changes.removed, (std::vector<VertexId>{3 * sides, perPart + 3 * sides}));
    EXPECT_EQ(changes.added.size(), 3U);
    // A band joins the stumps' rims.
    for (VertexId k = 0; k < sides; ++k) {
        const NeighbourRing &ring = mesh.ring(k);
        EXPECT_TRUE(std::any_of(ring.begin(), ring.end(), [](VertexId u) {
            return u >= perPart && u < perPart + sides;
        })) << k;
    }
}

TEST(TearMending, two_posts_that_end_at_a_gap_stay_as_they_are)
{
    NeuralMesh mesh;
    makeTornPost(mesh);
    // Samples on both ends and none on the wall between: nothing is torn.
    EXPECT_FALSE(mendTear(mesh, supportOfPost(false), 1000));
    EXPECT_EQ(mesh.vn, static_cast<int>(2 * perPart));
    EXPECT_EQ(findDefect(mesh), "");
}

TEST(TearMending, components_are_not_joined_though_one_has_a_handle_that_could_be_cut)
{
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    addHalf(points, faces, 1);
    addHalf(points, faces, -1);
    NeuralMesh mesh;
    test::makeMesh(mesh, points, faces);
    const VertexId up = sides;
    bridgeDiscs(mesh, rimOf(up, up + 1, up + sides + 1), rimOf(up + 4, up + 5, up + sides + 5),
                {{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 1}, {0, 1}});
    ASSERT_EQ(findDefect(mesh), "");
    ASSERT_EQ(measureTopology(mesh).genus, 1);
    EXPECT_FALSE(mendTear(mesh, supportOfPost(true), 1000));
    EXPECT_EQ(measureTopology(mesh).components, 2);
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

TEST(TearMending, a_tear_stays_where_mending_it_would_pass_the_target)
{
    NeuralMesh mesh;
    makeTornPost(mesh);
    const int before = mesh.vn;
    // Two vertices fewer and three more.
    EXPECT_FALSE(mendTear(mesh, supportOfPost(true), before));
    EXPECT_EQ(mesh.vn, before);
    EXPECT_EQ(findDefect(mesh), "");
}

} // namespace
} // namespace neuralmesh
