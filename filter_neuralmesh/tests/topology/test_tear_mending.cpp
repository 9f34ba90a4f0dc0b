// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/tear_mending.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

constexpr VertexId sides = 8;
constexpr VertexId perPart = 3 * sides + 2;

/// One half of a torn post: three levels of a prism, closed at both ends by fans. `sign` is 1 for
/// the upper and -1 for the lower half.
///
///      _______   z = 2.5
///     |       |
///     |_______|  z = 0.5, the stump
///      _______
///     |       |  z = -0.5, the other stump
///     |_______|  z = -2.5
void addHalf(std::vector<Point3> &points, std::vector<test::Triangle> &faces, int sign)
{
    const auto first = static_cast<VertexId>(points.size());
    for (int level = 1; level <= 3; ++level)
        for (VertexId k = 0; k < sides; ++k) {
            const Scalar angle = 2 * M_PI * k / sides;
            points.emplace_back(std::cos(angle), std::sin(angle), sign * (level - 0.5));
        }
    points.emplace_back(0, 0, 0.5 * sign);
    points.emplace_back(0, 0, 2.5 * sign);
    const auto at = [&](VertexId level, VertexId k) { return first + level * sides + k % sides; };
    const auto add = [&](VertexId a, VertexId b, VertexId c) {
        faces.push_back(sign > 0 ? test::Triangle{a, b, c} : test::Triangle{a, c, b});
    };
    for (VertexId k = 0; k < sides; ++k) {
        for (VertexId level = 0; level < 2; ++level) {
            add(at(level, k), at(level, k + 1), at(level + 1, k + 1));
            add(at(level, k), at(level + 1, k + 1), at(level + 1, k));
        }
        add(first + 3 * sides, at(0, k + 1), at(0, k));
        add(first + 3 * sides + 1, at(2, k), at(2, k + 1));
    }
}

/// A face of the mesh that has these corners, as a rim.
std::vector<VertexId> rimOf(VertexId a, VertexId b, VertexId c)
{
    return {a, b, c};
}

/// The torn post, its halves joined by a strand of triangular section far up and down its wall.
void makeTornPost(NeuralMesh &mesh)
{
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    addHalf(points, faces, 1);
    addHalf(points, faces, -1);
    test::makeMesh(mesh, points, faces);
    const VertexId up = sides;
    const VertexId down = perPart + sides;
    bridgeDiscs(mesh, rimOf(up, up + 1, up + sides + 1), rimOf(down, down + sides + 1, down + 1),
                {{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 1}, {0, 1}});
}

/// Samples all over the whole post, the missing part of its wall included.
SampleSupport supportOfPost(bool withWall)
{
    std::vector<Point3> samples;
    constexpr int around = 48;
    for (int i = 0; i < around; ++i) {
        const Scalar angle = 2 * M_PI * i / around;
        for (int z = -25; z <= 25; ++z)
            if (withWall || std::abs(z) >= 5)
                samples.emplace_back(std::cos(angle), std::sin(angle), z / 10.0);
        for (int r = 0; r < 10; ++r)
            for (const Scalar z : withWall ? std::vector<Scalar>{-2.5, 2.5}
                                           : std::vector<Scalar>{-2.5, -0.5, 0.5, 2.5})
                samples.emplace_back(r / 10.0 * std::cos(angle), r / 10.0 * std::sin(angle), z);
    }
    Box3 bounds;
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    return SampleSupport(bounds, samples);
}

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
