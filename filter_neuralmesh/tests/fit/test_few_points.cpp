// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fit/few_points.h"

#include <gtest/gtest.h>

#include "core/growth.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

const test::WorldPoints tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const test::WorldPoints cube = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

test::WorldPoints verticesOf(const test::WorldPoints &points, int count, std::uint64_t seed)
{
    const PointCloudSampler sampler(points);
    GrowthParameters parameters;
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

TEST(FewPoints, no_vertex_is_far_outside_the_box_of_the_points)
{
    // A twentieth of the diagonal, with some rounding.
    const double most = 0.05 * std::sqrt(3.0) + 1e-9;
    for (const int count : {4, 5, 6, 7, 8})
        for (const std::uint64_t seed : {1U, 2U, 3U})
            for (const vcg::Point3d &vertex : verticesOf(cube, count, seed))
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_GE(vertex[axis], -most);
                    EXPECT_LE(vertex[axis], 1 + most);
                }
}

} // namespace
} // namespace neuralmesh
