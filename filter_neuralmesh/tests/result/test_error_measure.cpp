// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/error_measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/enumeration.h"
#include "tests/meshes_for_tests.h"
#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

TEST(ErrorMeasure, finds_the_nearest_face_where_the_nearest_vertex_is_of_another_sheet)
{
    NeuralMesh mesh;
    test::makeFlatTorus(mesh, 24, 10);
    std::vector<Point3> onFaces;
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        onFaces.push_back((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3);
    });
    const test::FixedPoints sampler(onFaces);
    const GrowingNetwork network(mesh, toVcg(sampler.bounds()), GrowthParameters{});
    int onOtherSheet = 0;
    for (const Point3 &point : onFaces) {
        const Point3 nearest = mesh.position(network.nearestVertex(point));
        onOtherSheet += nearest.Z() * point.Z() < 0 ? 1 : 0;
    }
    ASSERT_GT(onOtherSheet, 20);
    Random random(1);
    const ErrorFigures error = errorOf(measureDistances(
        network, sampler, random, 10U * static_cast<std::size_t>(network.vertexCount())));
    EXPECT_LT(error.largest, 1e-12);
    EXPECT_LT(error.rms, 1e-12);
}

} // namespace
} // namespace neuralmesh
