// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/few_points.h"

#include <gtest/gtest.h>

#include "core/growth.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/points_for_tests.h"
#include "tests/promises.h"

namespace neuralmesh {
namespace {

const test::WorldPoints tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const test::WorldPoints cube = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

test::WorldPoints verticesOf(const test::WorldPoints &points, int count, std::uint64_t seed,
                             GrowthParameters parameters = {})
{
    const PointCloudSampler sampler(points);
    parameters.targetVertexCount = count;
    parameters.seed = seed;
    NeuralMesh mesh;
    grow(mesh, sampler, parameters);
    test::WorldPoints vertices;
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        if (mesh.isLive(v))
            vertices.push_back(toWorld(sampler.frame(), mesh.position(v)));
    return vertices;
}

void expectSamePlaces(test::WorldPoints found, const test::WorldPoints &wanted)
{
    ASSERT_EQ(found.size(), wanted.size());
    for (const vcg::Point3d &place : wanted) {
        double nearest = 1;
        for (const vcg::Point3d &vertex : found)
            nearest = std::min(nearest, (vertex - place).Norm());
        EXPECT_LT(nearest, 1e-12);
    }
}

TEST(FewPoints, as_many_vertices_as_points_are_on_the_points)
{
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        expectSamePlaces(verticesOf(tetrahedron, 4, seed), tetrahedron);
        expectSamePlaces(verticesOf(cube, 8, seed), cube);
    }
}

void expectNearUnitBox(const test::WorldPoints &vertices)
{
    // A twentieth of the diagonal, with some rounding.
    const double most = 0.05 * std::sqrt(3.0) + 1e-9;
    for (const vcg::Point3d &vertex : vertices)
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(vertex[axis], -most);
            EXPECT_LE(vertex[axis], 1 + most);
        }
}

TEST(FewPoints, no_vertex_is_far_outside_the_box_of_the_points)
{
    for (const int count : {4, 5, 6, 7, 8})
        for (const std::uint64_t seed : {1U, 2U, 3U})
            expectNearUnitBox(verticesOf(cube, count, seed));
}

/// Smoothing moves vertices along their planes, which lead out of the box at its corners.
TEST(FewPoints, no_vertex_is_far_outside_the_box_without_the_fit)
{
    GrowthParameters parameters;
    parameters.surfaceFit = false;
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U})
        expectNearUnitBox(verticesOf(tetrahedron, 4, seed, parameters));
}

/// Of an open result without the fit they are the growing network as it is.
TEST(FewPoints, no_vertex_of_a_snapshot_is_far_outside_the_box)
{
    const PointCloudSampler sampler(cube);
    GrowthParameters parameters;
    parameters.targetVertexCount = 8;
    parameters.surfaceFit = false;
    parameters.topology = Topology::ofStart;
    parameters.winnerRate = 0.3;
    parameters.snapshots = {4};
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        parameters.seed = seed;
        reconstruct(sampler, parameters, {}, [&](const Mesh &snapshot) {
            EXPECT_EQ(test::brokenPlaces(snapshot, sampler, false), "");
        });
    }
}

} // namespace
} // namespace neuralmesh
