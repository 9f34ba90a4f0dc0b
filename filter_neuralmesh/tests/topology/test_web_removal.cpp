// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/web_removal.h"

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
#include "core/topology/unsupported_patches.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

constexpr VertexId places = 8; ///< vertices of a level

/// Two posts joined by a web of one face's width in front and at the back, six levels high and
/// closed at top and bottom. The posts' inner walls are missing.
void makeWeb(NeuralMesh &mesh, Scalar gap)
{
    const Scalar loop[places][2] = {{1, -0.4}, {0, -1},        {-1, 0},      {0, 1},
                                    {1, 0.4},  {1 + gap, 0.4}, {3 + gap, 0}, {1 + gap, -0.4}};
    constexpr VertexId levels = 6;
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    for (VertexId level = 0; level < levels; ++level)
        for (const auto &[x, y] : loop)
            points.emplace_back(x, y, static_cast<Scalar>(level));
    const auto at = [](VertexId level, VertexId place) { return level * places + place % places; };
    // Clockwise seen from above, so each face looks outwards with its corners in this order.
    for (VertexId level = 0; level + 1 < levels; ++level)
        for (VertexId place = 0; place < places; ++place) {
            faces.push_back({{at(level, place), at(level + 1, place), at(level, place + 1)}});
            faces.push_back(
                {{at(level, place + 1), at(level + 1, place), at(level + 1, place + 1)}});
        }
    for (VertexId place = 1; place + 1 < places; ++place) {
        faces.push_back({{at(0, 0), at(0, place), at(0, place + 1)}});
        faces.push_back({{at(levels - 1, 0), at(levels - 1, place + 1), at(levels - 1, place)}});
    }
    test::makeMesh(mesh, points, faces);
}

/// Samples everywhere on the faces whose corners are all on one side of the gap, on the walls
/// between front and back, where there are no faces, and on the top, which joins the posts.
SampleSupport supportOfPosts(const NeuralMesh &mesh, Scalar gap)
{
    constexpr int steps = 8;
    std::vector<Point3> samples;
    const auto sampleTriangle = [&](const Point3 &a, const Point3 &b, const Point3 &c) {
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j)
                samples.push_back(a + (b - a) * i / steps + (c - a) * j / steps);
    };
    const FaceTable faces(mesh);
    for (FaceId face = 0; face < faces.size(); ++face) {
        const Corners &c = faces.corners(face);
        const auto isLeft = [&](VertexId v) { return mesh.position(v).X() < 1 + gap / 2; };
        const auto isOnTop = [&](VertexId v) { return mesh.position(v).Z() == 5; };
        const bool isTop = isOnTop(c[0]) && isOnTop(c[1]) && isOnTop(c[2]);
        if (isTop || (isLeft(c[0]) == isLeft(c[1]) && isLeft(c[1]) == isLeft(c[2])))
            sampleTriangle(mesh.position(c[0]), mesh.position(c[1]), mesh.position(c[2]));
    }
    for (const Scalar x : {Scalar(1), 1 + gap}) {
        sampleTriangle({x, -0.4, 0}, {x, 0.4, 0}, {x, 0.4, 5});
        sampleTriangle({x, -0.4, 0}, {x, 0.4, 5}, {x, -0.4, 5});
    }
    Box3 bounds;
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    return SampleSupport(bounds, samples);
}

TEST(WebRemoval, refilling_a_web_leaves_a_closed_two_manifold_of_the_same_topology)
{
    constexpr Scalar gap = 4;
    NeuralMesh mesh;
    makeWeb(mesh, gap);
    validate(mesh);
    const std::vector<Refilling> webs = findWebs(mesh, supportOfPosts(mesh, gap));
    ASSERT_EQ(webs.size(), 1U);
    refillDisc(mesh, webs[0].rim, webs[0].interior, webs[0].triangles);
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.genus, 0);
    EXPECT_EQ(topology.components, 1);
}

TEST(WebRemoval, a_mesh_on_its_samples_stays_as_it_is)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 30, 12);
    std::vector<Point3> samples;
    Box3 bounds;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        samples.push_back(mesh.position(v));
        bounds.Add(mesh.position(v));
        for (const VertexId u : mesh.ring(v))
            samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    }
    EXPECT_TRUE(findWebs(mesh, SampleSupport(bounds, samples)).empty());
}

/// A limb that too few samples show is not cut off: samples at its tip would be missed.
TEST(WebRemoval, a_spike_with_a_sample_at_its_tip_stays)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 30, 12);
    std::vector<Point3> samples;
    Box3 bounds;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        samples.push_back(mesh.position(v));
        for (const VertexId u : mesh.ring(v))
            samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    }
    mesh.position(0) = mesh.position(0) * 2;
    samples.push_back(mesh.position(0));
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    EXPECT_TRUE(findWebs(mesh, SampleSupport(bounds, samples)).empty());
}

TEST(PatchSearch, finds_the_two_sheets_and_the_rim_of_a_web_as_one_disc)
{
    constexpr Scalar gap = 4;
    NeuralMesh mesh;
    makeWeb(mesh, gap);
    const SampleSupport support = supportOfPosts(mesh, gap);
    const FaceTable faces(mesh);
    PatchSearch search(mesh, faces, support);
    FaceId seed = 0;
    while (!search.isSeed(seed))
        ++seed;
    const std::optional<Patch> patch = search.find(seed, PatchExtent::core);
    ASSERT_TRUE(patch);
    EXPECT_TRUE(patch->interior.empty());
    EXPECT_EQ(patch->faces.size() + 2, patch->rim.size()); // a disc without interior vertices
    EXPECT_FALSE(search.isSeed(seed)) << "its faces belong to it";
    search.release(*patch);
    EXPECT_TRUE(search.isSeed(seed));
}

} // namespace
} // namespace neuralmesh
