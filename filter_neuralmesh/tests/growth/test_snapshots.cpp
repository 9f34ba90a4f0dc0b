// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots of growth: levels of detail from one run.
#include <gtest/gtest.h>

#include "core/growth.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "neuralmesh/errors.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"
#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

using Snapshots = std::vector<std::unique_ptr<NeuralMesh>>;

GrowthParameters withSnapshots(std::vector<int> counts, bool surfaceFit = true)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = 800;
    parameters.snapshots = std::move(counts);
    parameters.surfaceFit = surfaceFit;
    return parameters;
}

const PointCloudSampler &sphere()
{
    static const PointCloudSampler sampler(test::spherePoints(50000, 7));
    return sampler;
}

Snapshots grown(NeuralMesh &mesh, const GrowthParameters &parameters)
{
    Snapshots snapshots;
    grow(mesh, sphere(), parameters, {},
         [&](std::unique_ptr<NeuralMesh> snapshot) { snapshots.push_back(std::move(snapshot)); });
    return snapshots;
}

std::vector<Point3> positions(const NeuralMesh &mesh)
{
    std::vector<Point3> all;
    for (const NeuralFace &face : mesh.face)
        for (int corner = 0; corner < 3; ++corner)
            all.push_back(face.cP(corner));
    return all;
}

/// Mean over the faces of the middle's distance from the sphere, in its radii.
double faceError(const NeuralMesh &mesh)
{
    double sum = 0;
    for (const NeuralFace &face : mesh.face) {
        const Point3 middle = (face.cP(0) + face.cP(1) + face.cP(2)) / 3;
        sum += std::abs(toWorld(sphere().frame(), middle).Norm() - 1);
    }
    return sum / mesh.fn;
}

TEST(Snapshots, are_closed_meshes_of_the_counts_asked_for_in_their_order)
{
    for (const bool surfaceFit : {true, false}) {
        NeuralMesh mesh;
        const Snapshots snapshots = grown(mesh, withSnapshots({4, 20, 100, 501, 800}, surfaceFit));
        ASSERT_EQ(snapshots.size(), 5U);
        const int counts[] = {4, 20, 100, 501, 800};
        for (std::size_t i = 0; i < 5; ++i) {
            validate(*snapshots[i]);
            EXPECT_EQ(snapshots[i]->vn, counts[i]);
            EXPECT_EQ(snapshots[i]->fn, 2 * counts[i] - 4);
            EXPECT_GT(signedVolume(*snapshots[i]), 0);
        }
    }
}

TEST(Snapshots, coarser_than_a_start_from_the_data_have_its_handles)
{
    Random random(3);
    test::WorldPoints points;
    while (points.size() < 8000) {
        const double a = 2 * M_PI * random.unit();
        const double b = 2 * M_PI * random.unit();
        if (random.unit() * 3 < 2 + std::cos(b))
            points.emplace_back((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a),
                                std::sin(b));
    }
    const PointCloudSampler torus(points);
    std::vector<int> taken;
    NeuralMesh mesh;
    grow(mesh, torus, withSnapshots({15, 60, 600}), {}, [&](std::unique_ptr<NeuralMesh> snapshot) {
        validate(*snapshot);
        EXPECT_EQ(measureTopology(*snapshot).genus, 1);
        taken.push_back(snapshot->vn);
    });
    EXPECT_EQ(taken, (std::vector<int>{15, 60, 600}));
    try {
        grow(mesh, torus, withSnapshots({4}), {}, [](std::unique_ptr<NeuralMesh>) {});
        FAIL() << "A torus of 4 vertices was accepted.";
    } catch (const InvalidInput &error) { // none has fewer than 7
        EXPECT_NE(std::string(error.what()).find("snapshots names 4 vertices, fewer than the "),
                  std::string::npos);
    }
}

TEST(Snapshots, leave_the_result_as_it_is_without_them)
{
    NeuralMesh without, with;
    grown(without, withSnapshots({}));
    grown(with, withSnapshots({20, 100, 501}));
    EXPECT_EQ(positions(with), positions(without)); // bit for bit
}

TEST(Snapshots, are_fitted_to_the_surface_where_the_result_is)
{
    NeuralMesh mesh;
    const double fitted = faceError(*grown(mesh, withSnapshots({300})).front());
    const double asItIs = faceError(*grown(mesh, withSnapshots({300}, false)).front());
    // A face of 300 vertices has its middle 0.013 inside the sphere that its corners lie on. The
    // fit leaves a tenth of that error.
    EXPECT_LT(fitted, 0.15 * asItIs);
}

TEST(Snapshots, are_taken_of_as_many_vertices_as_there_are_points)
{
    const PointCloudSampler sampler(test::spherePoints(300, 1));
    GrowthParameters parameters = withSnapshots({50, 300});
    parameters.targetVertexCount = 300;
    parameters.inactivityFactor = 2;
    NeuralMesh mesh;
    std::vector<int> taken;
    grow(mesh, sampler, parameters, {},
         [&](std::unique_ptr<NeuralMesh> snapshot) { taken.push_back(snapshot->vn); });
    EXPECT_EQ(taken, (std::vector<int>{50, 300}));
}

TEST(Snapshots, of_impossible_counts_are_refused)
{
    const auto refusal = [](std::vector<int> counts) -> std::string {
        NeuralMesh mesh;
        try {
            grown(mesh, withSnapshots(std::move(counts)));
        } catch (const InvalidInput &error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(refusal({20, 20}), "snapshots names 20 vertices twice.");
    EXPECT_EQ(refusal({20, 10}), "snapshots names 10 vertices after more of them.");
    EXPECT_EQ(refusal({3}),
              "snapshots names 3 vertices, fewer than the 4 vertices of the starting mesh.");
    EXPECT_EQ(refusal({801}), "snapshots names 801 vertices, more than targetVertexCount, which is "
                              "800.");
}

TEST(Snapshots, do_not_keep_a_run_from_being_cancelled)
{
    NeuralMesh mesh;
    bool hasSnapshot = false;
    const Progress stopAfterTheFirst = [&](double, const char *) { return !hasSnapshot; };
    EXPECT_THROW(grow(mesh, sphere(), withSnapshots({20, 500}), stopAfterTheFirst,
                      [&](std::unique_ptr<NeuralMesh>) { hasSnapshot = true; }),
                 Cancelled);
}

} // namespace
} // namespace neuralmesh
