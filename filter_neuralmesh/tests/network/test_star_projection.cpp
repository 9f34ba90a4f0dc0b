// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/star_projection.h"

#include <gtest/gtest.h>
#include <vcg/space/distance3.h>
#include <vcg/space/triangle3.h>

#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// VCG's distance to each face of the star.
Scalar distanceByVcg(const NeuralMesh &mesh, VertexId v, const Point3 &query)
{
    Scalar least = 1e30;
    for (int i = 0; i < mesh.valence(v); ++i) {
        const vcg::Triangle3<Scalar> face(mesh.position(v), mesh.position(mesh.ring(v)[i]),
                                          mesh.position(mesh.ring(v).at(i + 1)));
        Scalar distance = 1e30;
        Point3 nearest;
        vcg::TrianglePointDistance(face, query, distance, nearest);
        least = std::min(least, distance);
    }
    return least;
}

TEST(StarProjection, finds_the_distance_that_vcg_finds)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 7, 5);
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const auto v = static_cast<VertexId>(random.below(35));
        const Point3 query =
            mesh.position(v) + (test::inUnitCube(random) - Point3(0.5, 0.5, 0.5)) * 3;
        const StarProjection p = projectOnStar(mesh, v, query);
        ASSERT_NEAR(std::sqrt(p.squaredDistance), distanceByVcg(mesh, v, query), 1e-12);
        Point3 point(0, 0, 0);
        for (int corner = 0; corner < 3; ++corner) {
            ASSERT_GE(p.weights[corner], 0);
            point += mesh.position(p.corners[corner]) * p.weights[corner];
        }
        ASSERT_NEAR(p.weights[0] + p.weights[1] + p.weights[2], 1, 1e-12);
        ASSERT_NEAR((point + p.residual - query).Norm(), 0, 1e-12);
    }
}

TEST(StarProjection, is_the_vertex_where_all_faces_are_a_single_place)
{
    NeuralMesh mesh;
    makeTetrahedron(mesh, {1, 1, 1}, 0);
    const StarProjection p = projectOnStar(mesh, 0, {1, 1, 3});
    EXPECT_EQ(p.corners[0], 0U);
    EXPECT_EQ(p.weights[0], 1);
    EXPECT_EQ(p.squaredDistance, 4);
    EXPECT_FALSE(liesOnBoundary(mesh, p));
}

} // namespace
} // namespace neuralmesh
