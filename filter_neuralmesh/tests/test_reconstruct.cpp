// SPDX-License-Identifier: GPL-3.0-or-later
// The library as its users call it: public headers only.
#include "neuralmesh/reconstruct.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "neuralmesh/errors.h"
#include "neuralmesh/sampler_errors.h"
#include "neuralmesh/samplers.h"

namespace neuralmesh {
namespace {

/// A sphere of radius 2 far from the origin.
const Point centre{500, -300, 100};

std::unique_ptr<Sampler> sphere()
{
    return implicitSurfaceSampler({"f", "(x-500)^2 + (y+300)^2 + (z-100)^2 - 4"},
                                  {{495, -305, 95}, {505, -295, 105}});
}

GrowthParameters withTarget(int vertices)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = vertices;
    return parameters;
}

double distanceFromSphere(const Point &p)
{
    return std::abs(std::hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]) - 2);
}

double signedVolume(const Mesh &mesh)
{
    double volume = 0;
    for (const Corners &f : mesh.triangles) {
        Point p[3];
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t axis = 0; axis < 3; ++axis)
                p[c][axis] = mesh.positions[f[c]][axis] - centre[axis];
        volume += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                   p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                   p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
                  6;
    }
    return volume;
}

/// A torus of 8 by 5 quads around the z axis, of radii 2 and 1.
Mesh torus()
{
    Mesh mesh;
    const double step = 2 * std::acos(-1);
    for (VertexId i = 0; i < 8; ++i)
        for (VertexId j = 0; j < 5; ++j) {
            const double a = step * i / 8;
            const double b = step * j / 5;
            mesh.positions.push_back(
                {(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)});
            const VertexId here = i * 5 + j;
            const VertexId right = (i + 1) % 8 * 5 + j;
            const VertexId up = i * 5 + (j + 1) % 5;
            const VertexId both = (i + 1) % 8 * 5 + (j + 1) % 5;
            mesh.triangles.push_back({here, right, both});
            mesh.triangles.push_back({here, both, up});
        }
    return mesh;
}

TEST(Reconstruct, gives_a_sphere_in_world_coordinates_with_its_outside_outwards)
{
    const Result result = reconstruct(*sphere(), withTarget(500));
    ASSERT_EQ(result.mesh.positions.size(), 500U);
    ASSERT_EQ(result.mesh.triangles.size(), 996U);
    // The sagitta of an edge of 0.34 on radius 2 is 0.007: vertices lie off by less.
    for (const Point &p : result.mesh.positions)
        EXPECT_LT(distanceFromSphere(p), 0.02);
    const double volume = 4.0 / 3 * std::acos(-1) * 8;
    EXPECT_NEAR(signedVolume(result.mesh) / volume, 1, 0.01);
}

TEST(Reconstruct, reports_in_units_of_the_input)
{
    const Result result = reconstruct(*sphere(), withTarget(500));
    const Report &report = result.report;
    EXPECT_EQ(report.vertices, 500);
    EXPECT_EQ(report.faces, 996);
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.genus, 0);
    EXPECT_TRUE(report.reachedTarget);
    int counted = 0;
    for (const int count : report.valenceHistogram)
        counted += count;
    EXPECT_EQ(counted, 500);
    // A face with edges of 0.34 on radius 2 departs by 0.005 in the mean square when it is fitted,
    // of the diagonal that is 0.0007.
    EXPECT_GT(report.rmsError, 0.001);
    EXPECT_LT(report.rmsError, 0.01);
    EXPECT_GT(report.maxError, report.rmsError);
    ASSERT_EQ(report.convergence.size(), 6U); // 8 to 256 vertices
    EXPECT_GT(report.convergence[0], 0.1);
}

TEST(Reconstruct, from_a_mesh_that_is_given_keeps_its_handles)
{
    const auto target = implicitSurfaceSampler({"f", "(sqrt(x*x + y*y) - 2)^2 + z*z - 1"},
                                               {{-4, -4, -2}, {4, 4, 2}});
    const Result result = reconstructFrom(torus(), *target, withTarget(300));
    EXPECT_EQ(result.report.vertices, 300);
    EXPECT_EQ(result.report.genus, 1);
}

TEST(Reconstruct, hands_out_snapshots_that_never_touch_the_result)
{
    GrowthParameters parameters = withTarget(300);
    const Result alone = reconstruct(*sphere(), parameters);
    parameters.snapshots = {50, 100};
    std::vector<Mesh> taken;
    const Result result = reconstruct(*sphere(), parameters, {},
                                      [&](Mesh snapshot) { taken.push_back(std::move(snapshot)); });
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_EQ(taken[0].positions.size(), 50U);
    EXPECT_EQ(taken[1].positions.size(), 100U);
    EXPECT_LT(distanceFromSphere(taken[1].positions[0]), 0.2);
    EXPECT_EQ(result.mesh.positions, alone.mesh.positions);
    EXPECT_EQ(result.mesh.triangles, alone.mesh.triangles);
}

TEST(Reconstruct, refuses_by_type_with_the_parameter_and_its_figures)
{
    try {
        reconstruct(*sphere(), withTarget(3));
        FAIL() << "three vertices were accepted";
    } catch (const InvalidParameter &error) {
        EXPECT_EQ(error.parameter(), Parameter::targetVertexCount);
        EXPECT_EQ(error.problem(), InvalidParameter::Problem::belowLeast);
        EXPECT_EQ(error.value(), 3);
        EXPECT_EQ(error.limit(), 4);
        EXPECT_STREQ(error.what(), "targetVertexCount must be at least 4, not 3.");
        EXPECT_EQ(error.sentence([](Parameter) { return "vertices"; }),
                  "vertices must be at least 4, not 3.");
    }
    GrowthParameters parameters;
    parameters.startMesh = StartMesh::given;
    EXPECT_THROW(reconstruct(*sphere(), parameters), InvalidStartingMesh);
    EXPECT_THROW(reconstructFrom({}, *sphere()), InvalidStartingMesh);
    EXPECT_THROW(reconstructFrom(torus(), *sphere(), withTarget(39)), InvalidParameter);
}

TEST(Reconstruct, ends_when_it_is_told_to)
{
    EXPECT_THROW(reconstruct(*sphere(), {}, [](double, const char *) { return false; }), Cancelled);
}

TEST(Samplers, refuse_indices_and_densities_that_do_not_fit)
{
    Mesh mesh = torus();
    EXPECT_THROW(surfaceSampler(mesh, {1, 2, 3}), InvalidDensity);
    EXPECT_THROW(pointCloudSampler(mesh.positions, {1, 2, 3}), InvalidDensity);
    std::vector<double> density(40, 1.0);
    density[7] = -1;
    density[9] = std::nan("");
    try {
        pointCloudSampler(mesh.positions, density);
        FAIL() << "a negative density was accepted";
    } catch (const InvalidDensity &error) {
        EXPECT_EQ(error.problem(), InvalidDensity::Problem::notValid);
        EXPECT_EQ(error.broken(), 2U);
        EXPECT_EQ(error.count(), 40U);
        EXPECT_EQ(error.first(), 7U);
    }
    EXPECT_THROW(pointCloudSampler(mesh.positions, std::vector<double>(40, 0.0)), InvalidDensity);
    mesh.triangles[0][1] = 40;
    EXPECT_THROW(surfaceSampler(mesh), InvalidInput);
}

} // namespace
} // namespace neuralmesh
