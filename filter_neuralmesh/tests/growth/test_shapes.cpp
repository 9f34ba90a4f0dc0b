// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of shapes that a simpler algorithm gets wrong: each test but one stands for
// mechanisms that scripts/test --mutants switches off, and fails without any of them.
//
// Bounds lie between the figures with and without, which the comments give for the seeds here, in
// per cent of the points' diagonal.
#include <gtest/gtest.h>

#include "core/growth.h"
#include "core/mesh/mesh_checks.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/shapes_for_tests.h"

namespace neuralmesh {
namespace {

using test::box;
using test::capsule;
using test::Shape;
using test::WorldPoints;
using Place = vcg::Point3d;

/// A mesh as it came out, and how far it is from what it should be.
struct Grown {
    GrowthReport report;
    test::Deviation fromShape; ///< of places on the mesh
    test::Deviation fromMesh;  ///< of points on the shape
};

GrowthParameters withTarget(int target, std::uint64_t seed)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = target;
    parameters.seed = seed;
    parameters.topology = Topology::ofStart; // growth finds the shape by itself
    return parameters;
}

/// From `cloud`, which is `clean`, points of the shape, with what has been done to them.
Grown growFrom(const WorldPoints &cloud, const GrowthParameters &parameters, const Shape &shape,
               const WorldPoints &clean)
{
    const PointCloudSampler sampler(cloud);
    NeuralMesh mesh;
    const GrowthReport report = grow(mesh, sampler, parameters);
    validate(mesh);
    EXPECT_EQ(mesh.vn, parameters.targetVertexCount);
    return {report, test::meshToShape(mesh, sampler.frame(), shape),
            test::pointsToMesh(clean, sampler.frame(), mesh)};
}

/// A young network spans the angle between two arms with a sheet, and has to let go.
TEST(Shapes, an_angle_has_no_web_between_its_arms)
{
    const Shape angle({capsule({0, 0, 0}, {3, 0, 0}, 0.1), capsule({0, 0, 0}, {0, 3, 0}, 0.1)});
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
        const WorldPoints points = angle.points(6000, seed);
        GrowthParameters parameters = withTarget(300, seed);
        parameters.surfaceFit = false;
        const Grown grown = growFrom(points, parameters, angle, points);
        // 0.61 to 0.69, of chords across round arms. With λ throughout, five of the six have a web:
        // 6.3 to 9.4. Where no edge is flipped away from a void, four: 4.1 to 6.1.
        EXPECT_LT(grown.fromShape.rms, 1) << seed;
    }
}

/// Body, neck, head, tail and four legs.
Shape animal()
{
    std::vector<test::Body> bodies{
        capsule({-1, 0, 0}, {1, 0, 0}, 0.45), capsule({1, 0, 0.2}, {1.7, 0, 1}, 0.18),
        capsule({1.7, 0, 1}, {2.1, 0, 0.9}, 0.2), capsule({-1.3, 0, 0.2}, {-2.2, 0, -0.6}, 0.06)};
    for (const double x : {-1.0, 1.0})
        for (const double y : {-0.25, 0.25})
            bodies.push_back(capsule({x, y, -0.2}, {x, y, -1.8}, 0.12));
    return Shape(bodies);
}

/// From a start of its shape.
TEST(Shapes, an_animal_has_its_limbs)
{
    const Shape shape = animal();
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const WorldPoints points = shape.points(20000, seed);
        GrowthParameters parameters = withTarget(1500, seed);
        parameters.topology = Topology::learned;
        const Grown grown = growFrom(points, parameters, shape, points);
        // Of twelve seeds, 0.039 to 0.044 and 0.027 to 0.033. From a tetrahedron, two of these
        // three have a torn limb: 0.15 and more.
        EXPECT_LT(grown.fromShape.rms, 0.12) << seed;
        EXPECT_LT(grown.fromMesh.rms, 0.12) << seed;
        EXPECT_EQ(grown.report.selfIntersections, 0) << seed;
    }
}

/// A ball with twelve small pegs, which have few of the samples.
TEST(Shapes, vertices_go_where_the_surface_bends_most)
{
    Random random(1);
    std::vector<test::Body> bodies{capsule({0, 0, 0}, {0, 0, 0}, 1)};
    for (int peg = 0; peg < 12; ++peg) {
        const Place direction = test::randomDirection(random);
        bodies.push_back(capsule(direction, direction * 1.15, 0.08));
    }
    const Shape shape(bodies);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const WorldPoints points = shape.points(20000, seed);
        const Grown grown = growFrom(points, withTarget(1000, seed), shape, points);
        // 0.053 to 0.061; where every signal counts 1, 0.111 to 0.143.
        EXPECT_LT(grown.fromShape.rms, 0.085) << seed;
    }
}

/// Outliers far and near; those near the surface are not known as such when samples are drawn.
TEST(Shapes, a_sphere_among_outliers_is_as_accurate_as_without)
{
    const Shape sphere({capsule({0, 0, 0}, {0, 0, 0}, 1)});
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const WorldPoints clean = sphere.points(20000, seed);
        const Grown grown =
            growFrom(test::withOutliers(clean, 0.05, seed), withTarget(1000, seed), sphere, clean);
        // 0.018 to 0.022, without outliers 0.018; where each sample pulls the same, 0.028 to 0.031.
        EXPECT_LT(grown.fromShape.rms, 0.025) << seed;
    }
}

/// A plate as thick as an edge is long: at the fit, samples of one wall pull at faces of the other.
TEST(Shapes, a_thin_plate_does_not_cross_itself)
{
    const Shape plate({box({1, 1, 0.05})});
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const WorldPoints points = plate.points(20000, seed);
        const Grown grown = growFrom(points, withTarget(1000, seed), plate, points);
        EXPECT_EQ(grown.report.selfIntersections, 0) << seed; // 868 to 1,029 if left as they are
    }
}

/// The animal's left half, as a scanner beside it sees it. The sheet that closes the scan is far
/// from all samples, as a web is; laid onto the scan, it fights for its samples.
TEST(Shapes, a_scan_of_one_side_keeps_its_points_on_the_mesh)
{
    const Shape shape = animal();
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        WorldPoints seen;
        for (const Place &p : shape.points(30000, seed))
            if (p[1] > 0.05)
                seen.push_back(p);
        const Grown grown = growFrom(seen, withTarget(1200, seed), shape, seen);
        // 0.26 to 0.36; where that sheet is laid onto the scan, 0.75 to 0.96.
        EXPECT_LT(grown.fromMesh.rms, 0.5) << seed;
    }
}

/// Seconds of this process's own.
/// Where the points are no denser than the vertices, all of the mesh is further from them than half
/// an edge. It is no web for that, and need not be searched for a better filling all over.
TEST(Shapes, few_points_are_no_reason_to_look_for_webs_everywhere)
{
    const Shape shape = animal();
    int removed = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const PointCloudSampler sampler(shape.points(2000, seed));
        NeuralMesh mesh;
        removed += grow(mesh, sampler, withTarget(1300, seed)).changes.websRemoved;
    }
    EXPECT_LT(removed, 10);
}

/// Of ground around a scanner that turns by equal angles, 1.8 above it and up to 30 away: half of
/// the points lie within 3 of it. Most of the area is further from all points than edges are long.
TEST(Shapes, where_points_are_sparse_faces_far_from_them_are_supported)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Random random(seed);
        WorldPoints points;
        for (int i = 0; i < 60000; ++i) {
            const double r = 1.8 / std::tan(0.06 + random.unit());
            const double angle = 2 * M_PI * random.unit();
            const double x = r * std::cos(angle);
            const double y = r * std::sin(angle);
            points.push_back({x, y, 0.5 * std::sin(x / 20) * std::cos(y / 25)});
        }
        GrowthParameters parameters = withTarget(1500, seed);
        parameters.topology = Topology::learned;
        parameters.boundaries = BoundaryRule::open;
        const PointCloudSampler sampler(points);
        NeuralMesh mesh;
        // 0.34 and more, where one length tells near from far.
        EXPECT_LT(grow(mesh, sampler, parameters).unsupportedArea, 0.02) << seed;
    }
}

} // namespace
} // namespace neuralmesh
