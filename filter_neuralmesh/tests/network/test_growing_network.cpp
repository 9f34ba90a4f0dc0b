// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/growing_network.h"

#include <gtest/gtest.h>

#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
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

/// Samples in the middle of every edge: none of them is a web.
SampleSupport supportAtMiddles(const NeuralMesh &mesh)
{
    std::vector<Point3> samples;
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        for (const VertexId u : mesh.ring(v))
            samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    return SampleSupport(boundsOf(mesh), samples);
}

TEST(GrowingNetwork, the_winner_moves_by_its_rate_towards_the_sample)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    GrowthParameters parameters;
    GrowingNetwork network(mesh, boundsOf(mesh), parameters);
    const Point3 sample(1.5, 0.2, 0);
    ASSERT_EQ(network.findWinner(sample), 0U);
    network.adapt(0, sample);
    const Point3 expected = Point3(1, 0, 0) * (1 - 0.06) + sample * 0.06;
    EXPECT_NEAR((mesh.position(0) - expected).Norm(), 0, 1e-15);
    EXPECT_EQ(network.findWinner({1.1, 0, 0}), 0U);
}

TEST(GrowingNetwork, smoothing_moves_the_neighbours_within_their_tangent_planes)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    GrowthParameters parameters;
    parameters.smoothingPasses = 1;
    parameters.smoothingRate = 0.25;
    GrowingNetwork network(mesh, boundsOf(mesh), parameters);
    // The sample is where the winner is: only the smoothing moves. By symmetry the Laplacian of
    // each neighbour is along its normal at first, so that nothing moves at all.
    network.adapt(0, {1, 0, 0});
    for (VertexId v = 0; v < 6; ++v)
        EXPECT_NEAR(std::abs(mesh.position(v).Norm()), 1, 1e-15);
    // With the winner pulled aside, its neighbours follow sideways.
    network.adapt(0, {1, 0.5, 0});
    EXPECT_GT(mesh.position(4).Y(), 0);
    EXPECT_GT(mesh.position(5).Y(), 0);
    EXPECT_EQ(mesh.position(1), Point3(-1, 0, 0)); // no neighbour of the winner
}

TEST(GrowingNetwork, smoothing_moves_a_boundary_along_itself_only)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 4);
    mesh.position(1).X() = 1.3; // not in the middle of its neighbours on the lower side
    mesh.position(6) = {1.2, 0.7, 0};
    Box3 bounds = boundsOf(mesh);
    GrowingNetwork network(mesh, bounds, GrowthParameters{});
    // The winner is where its sample is: only the smoothing moves. The umbrella of a vertex on the
    // boundary points inwards.
    network.adapt(6, mesh.position(6));
    EXPECT_LT(mesh.position(1).X(), 1.29);
    EXPECT_EQ(mesh.position(1).Y(), 0);
    EXPECT_EQ(mesh.position(5).X(), 0);
}

TEST(GrowingNetwork, a_sample_beyond_the_boundary_is_won_by_the_boundary)
{
    // A triangle: 0 and 1 are the ends of its long lower edge, 2 is close above that edge's middle.
    NeuralMesh mesh;
    test::makeMesh(mesh, {{-2, 0, 0}, {2, 0, 0}, {0, 0.2, 0}, {0, 3, 0}},
                   {{{0, 1, 2}}, {{1, 3, 2}}, {{3, 0, 2}}});
    const Point3 sample(0.3, -0.3, 0);
    GrowthParameters parameters;
    const GrowingNetwork network(mesh, boundsOf(mesh), parameters);
    ASSERT_EQ(network.nearestVertex(sample), 2U);
    EXPECT_EQ(network.findWinner(sample), 1U);
    EXPECT_EQ(network.findWinner({0.3, 0.1, 0}), 2U); // within the surface
    parameters.splitRule = SplitRule::paper;
    NeuralMesh same;
    same.copyNetwork(mesh);
    EXPECT_EQ(GrowingNetwork(same, boundsOf(mesh), parameters).findWinner(sample), 2U);
}

TEST(GrowingNetwork, webs_are_looked_for_in_closed_meshes_only)
{
    // Far from all samples, but open.
    NeuralMesh mesh;
    test::makeSquare(mesh, 35);
    ASSERT_GT(mesh.vn, 1000);
    const std::vector<Point3> samples{{0, 0, 0}, {35, 35, 0}};
    GrowingNetwork network(mesh, boundsOf(mesh), GrowthParameters{});
    network.collapse({100}, SampleSupport(boundsOf(mesh), samples));
    validate(mesh);
    EXPECT_EQ(network.vertexCount(), 36 * 36 - 1);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
}

TEST(GrowingNetwork,
     samples_of_a_sheet_are_won_and_projected_on_it_where_another_has_nearer_vertices)
{
    NeuralMesh mesh;
    test::makeFlatTorus(mesh, 60, 10); // no longer young
    const GrowingNetwork network(mesh, boundsOf(mesh), {});
    int nearerToOther = 0;
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        const Point3 sample = (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3;
        const VertexId nearest = network.nearestVertex(sample, noVertex);
        if (nearest == a || nearest == b || nearest == c)
            return;
        ++nearerToOther;
        const VertexId winner = network.findWinner(sample, noVertex);
        EXPECT_TRUE(winner == a || winner == b || winner == c);
        EXPECT_NEAR(network.project(nearest, sample).squaredDistance, 0, 1e-20);
    });
    EXPECT_GT(nearerToOther, 100);
}

TEST(GrowingNetwork, the_most_active_vertex_is_split_at_the_middle_of_its_longest_edge)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    mesh.position(2) = {0, 3, 0};
    GrowingNetwork network(mesh, boundsOf(mesh), {});
    network.countSignal(1, mesh.position(1));
    network.countSignal(0, mesh.position(0));
    network.countSignal(0, mesh.position(0));
    const VertexId w = network.splitMostActive();
    validate(mesh);
    EXPECT_EQ(network.vertexCount(), 7);
    EXPECT_EQ(mesh.position(w), Point3(0.5, 1.5, 0));
    EXPECT_TRUE(mesh.ring(w).contains(2));
    EXPECT_FALSE(mesh.ring(0).contains(2));
}

TEST(GrowingNetwork, removes_just_the_vertices_that_stopped_winning)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 6, 6);
    GrowthParameters parameters;
    parameters.inactivityFactor = 2;
    GrowingNetwork network(mesh, boundsOf(mesh), parameters);
    for (int round = 0; round < 3; ++round)
        for (VertexId v = 0; v < 36; ++v)
            if (v != 8 && v != 21)
                network.countSignal(v, mesh.position(v));
    ASSERT_TRUE(network.collapseIsDue());
    network.collapseInactive(supportAtMiddles(mesh));
    EXPECT_EQ(network.verticesRemoved(), 2U);
    validate(mesh);
    EXPECT_FALSE(mesh.isLive(8));
    EXPECT_FALSE(mesh.isLive(21));
    EXPECT_EQ(network.vertexCount(), 34);
    EXPECT_FALSE(network.collapseIsDue());
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

TEST(GrowingNetwork, never_collapses_below_a_tetrahedron)
{
    NeuralMesh mesh;
    makeTetrahedron(mesh, {0, 0, 0}, 1);
    GrowingNetwork network(mesh, boundsOf(mesh), {});
    for (int i = 0; i < 1000; ++i)
        network.countSignal(0, mesh.position(0));
    network.collapseInactive(supportAtMiddles(mesh));
    EXPECT_EQ(network.vertexCount(), 4);
}

/// Whether a torus of 1,000 vertices is taken for an open surface when there are samples where x is
/// above `from` only.
bool isOpenWithSamplesFrom(Scalar from)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 50, 20);
    std::vector<Point3> samples;
    Box3 bounds;
    for (const NeuralVertex &vertex : mesh.vert) {
        bounds.Add(vertex.cP());
        if (vertex.cP().X() > from)
            samples.push_back(vertex.cP());
    }
    GrowingNetwork network(mesh, bounds, GrowthParameters{});
    network.collapse({}, SampleSupport(bounds, samples));
    EXPECT_EQ(findDefect(mesh), "");
    return network.isOpenSurface();
}

TEST(GrowingNetwork, a_large_part_without_samples_makes_an_open_surface)
{
    EXPECT_TRUE(isOpenWithSamplesFrom(0)); // half of the torus
}

TEST(GrowingNetwork, a_web_does_not)
{
    EXPECT_FALSE(isOpenWithSamplesFrom(-2.5)); // beyond lies about a tenth
    EXPECT_FALSE(isOpenWithSamplesFrom(-4));   // nothing
}

} // namespace
} // namespace neuralmesh
