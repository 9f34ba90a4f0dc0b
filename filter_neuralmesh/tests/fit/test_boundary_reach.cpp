// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/boundary_reach.h"

#include <gtest/gtest.h>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/network/growing_network.h"
#include "neuralmesh/random.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

constexpr VertexId size = 8;

Box3 wideBounds()
{
    Box3 bounds;
    bounds.Add(Point3(-5, -5, -5));
    bounds.Add(Point3(15, 15, 5));
    return bounds;
}

/// Feeds samples of a flat square that reaches so far beyond that of the mesh.
void feed(BoundaryReach &reach, const GrowingNetwork &network, Scalar beyond, int samples)
{
    Random random(1);
    const Scalar side = size + 2 * beyond;
    for (int i = 0; i < samples; ++i) {
        const Scalar x = random.unit() * side - beyond;
        const Point3 sample(x, random.unit() * side - beyond, 0);
        reach.add(network.project(network.nearestVertex(sample), sample));
    }
}

/// Where the system wants the vertex to go, in the mesh's plane.
Point3 wanted(const BoundaryReach &reach, VertexId v,
              const Eigen::Vector3d &toCentre = Eigen::Vector3d::Zero())
{
    const BoundaryReach::Pull pull = reach.pull(v, toCentre);
    const Eigen::Matrix3d system = pull.system + 1e-6 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d d = system.ldlt().solve(pull.pull);
    return {d[0], d[1], d[2]};
}

TEST(BoundaryReach, finds_how_far_the_samples_reach_beyond_or_fall_short)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, size);
    const GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    for (const Scalar beyond : {0.4, 0.1, 0.0, -0.1}) {
        BoundaryReach reach(mesh);
        feed(reach, network, beyond, 400000);
        for (VertexId i = 1; i < size; ++i) {
            EXPECT_NEAR(wanted(reach, i).Y(), -beyond, 0.02) << beyond << " " << i;
            EXPECT_NEAR(wanted(reach, size * (size + 1) + i).Y(), beyond, 0.02);
        }
        // Two edges, each across: a corner goes where both sides do, if somewhat further.
        for (const VertexId corner : {VertexId(0), size, size * (size + 1), size * (size + 2)}) {
            const Point3 d = wanted(reach, corner);
            EXPECT_NEAR(std::abs(d.X()), std::abs(beyond), 0.1) << beyond;
            EXPECT_NEAR(std::abs(d.Y()), std::abs(beyond), 0.1) << beyond;
        }
    }
}

TEST(BoundaryReach, sees_a_boundary_that_goes_to_and_fro)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, size);
    for (VertexId i = 1; i < size; ++i)
        mesh.position(i).Y() = i % 2 == 0 ? 0.1 : -0.1;
    const GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    BoundaryReach reach(mesh);
    feed(reach, network, 0, 400000);
    for (VertexId i = 2; i + 1 < size; ++i) // each edge is right in the mean
        EXPECT_GT(wanted(reach, i).Y() * (i % 2 == 0 ? -1 : 1), 0.01) << i;
}

TEST(BoundaryReach, believes_points_that_are_drawn_over_and_over_no_more_than_once)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, size);
    const GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    const Eigen::Vector3d toCentre(0, 0.1, 0);
    double least = -1; // from the many samples to the neighbours, the less is known
    for (const double information : {10.0, 0.01, 0.0001}) {
        BoundaryReach reach(mesh);
        reach.fade(information);
        feed(reach, network, 0.1, 4000);
        const double y = wanted(reach, 4, toCentre).Y();
        EXPECT_GT(y, least) << information;
        least = y;
    }
    EXPECT_NEAR(least, toCentre.y(), 0.02);
}

TEST(BoundaryReach, follows_a_boundary_that_moves)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, size);
    GrowingNetwork network(mesh, wideBounds(), GrowthParameters{});
    BoundaryReach reach(mesh);
    feed(reach, network, 0.1, 400000);
    VertexData<Point3> before(mesh);
    forEachVertex(mesh, [&](VertexId v) { before[v] = mesh.position(v); });
    for (VertexId i = 0; i <= size; ++i)
        network.moveVertex(i, mesh.position(i) + Point3(0, -0.05, 0));
    reach.follow(before);
    for (VertexId i = 1; i < size; ++i)
        EXPECT_NEAR(wanted(reach, i).Y(), -0.05, 0.02) << i;
}

} // namespace
} // namespace neuralmesh
