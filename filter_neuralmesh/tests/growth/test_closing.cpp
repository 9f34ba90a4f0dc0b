// SPDX-License-Identifier: GPL-3.0-or-later
// Open points: borders that are those of the points; and with a closed result, watertight, of the
// exact count, without crossings.
#include <gtest/gtest.h>

#include <cmath>

#include "core/closing.h"
#include "core/growth.h"
#include "core/mesh/boundary.h"
#include "core/mesh/mesh_checks.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"
#include "tests/points_for_tests.h"
#include "tests/shapes_for_tests.h"

namespace neuralmesh {
namespace {

using test::WorldPoints;

/// A square sheet, bent.
WorldPoints sheet(std::size_t count)
{
    Random random(1);
    WorldPoints points;
    for (std::size_t i = 0; i < count; ++i) {
        const vcg::Point3d p = test::inUnitCube(random);
        points.emplace_back(p.X(), p.Y(), 0.2 * std::sin(3 * p.X()) * p.Y());
    }
    return points;
}

/// Of radius 1 and height 4, without its ends.
WorldPoints tube(std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    WorldPoints points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * random.unit();
        points.emplace_back(std::cos(angle), std::sin(angle), 4 * random.unit());
    }
    return points;
}

GrowthParameters closed(int target, std::uint64_t seed)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = target;
    parameters.seed = seed;
    parameters.topology = Topology::learned;
    parameters.boundaries = BoundaryRule::closed;
    return parameters;
}

void expectClosed(const NeuralMesh &mesh, int count)
{
    validate(mesh);
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_EQ(mesh.vn, count);
    const TopologyFigures figures = measureTopology(mesh);
    EXPECT_EQ(figures.genus, 0);
    EXPECT_EQ(figures.components, 1);
}

TEST(Closing, doubles_a_sheet_to_any_count)
{
    const PointCloudSampler sampler(sheet(5000));
    for (const bool surfaceFit : {true, false})
        for (int target = 400; target < 408; ++target) {
            GrowthParameters parameters = closed(target, 1);
            parameters.surfaceFit = surfaceFit;
            NeuralMesh mesh;
            const GrowthReport report = grow(mesh, sampler, parameters);
            expectClosed(mesh, target);
            EXPECT_TRUE(report.reachedTarget);
            EXPECT_EQ(report.selfIntersections, 0) << target;
            EXPECT_EQ(report.unsupportedArea, 0) << target; // no disc
            EXPECT_EQ(report.changes.sheetsDoubled, 1) << target;
        }
}

/// What the start has beyond the border wins nothing and goes, which folds it where nothing keeps
/// it from that.
TEST(Closing, a_flat_sheet_has_no_folds)
{
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
        Random random(seed);
        WorldPoints points;
        for (int i = 0; i < 20000; ++i) {
            const vcg::Point3d p = test::inUnitCube(random);
            points.emplace_back(p.X(), p.Y(), 0);
        }
        const PointCloudSampler sampler(points);
        NeuralMesh mesh;
        EXPECT_EQ(grow(mesh, sampler, closed(5000, seed)).selfIntersections, 0) << seed;
    }
}

/// A height field over a grid of 60 by 40, among outliers.
WorldPoints terrainAmongOutliers(std::uint64_t seed)
{
    WorldPoints points;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 40; ++j) {
            const double x = i / 20.0;
            const double y = j / 20.0;
            points.emplace_back(x, y,
                                0.15 * std::sin(2.1 * x) * std::cos(1.7 * y) +
                                    0.05 * std::sin(6 * x + 2 * y));
        }
    return test::withOutliers(std::move(points), 0.15, seed);
}

TEST(Closing, a_sheet_among_outliers_is_one_piece_without_folds)
{
    int right = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const PointCloudSampler sampler(terrainAmongOutliers(seed));
        NeuralMesh mesh;
        const GrowthReport report = grow(mesh, sampler, closed(1200, seed));
        right += report.selfIntersections == 0 && measureTopology(mesh).components == 1 ? 1 : 0;
    }
    EXPECT_GE(right, 10); // 11, of sheets read from a finer grid 2
}

TEST(Closing, snapshots_of_a_sheet_are_closed_and_of_their_count)
{
    const PointCloudSampler sampler(sheet(5000));
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        for (const bool surfaceFit : {true, false}) {
            GrowthParameters parameters = closed(500, seed);
            parameters.surfaceFit = surfaceFit;
            parameters.snapshots = {450, 451, 480};
            std::size_t taken = 0;
            NeuralMesh mesh;
            grow(mesh, sampler, parameters, {}, [&](std::unique_ptr<NeuralMesh> snapshot) {
                expectClosed(*snapshot, parameters.snapshots[taken++]);
            });
            EXPECT_EQ(taken, parameters.snapshots.size());
            expectClosed(mesh, 500);
        }
}

TEST(Closing, discs_over_a_ragged_border_cross_nothing)
{
    // So few points that the border goes to and fro: three of these discs would cross.
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
        const PointCloudSampler sampler(tube(1500, seed));
        NeuralMesh mesh;
        const GrowthReport report = grow(mesh, sampler, closed(1000, seed));
        expectClosed(mesh, 1000);
        EXPECT_EQ(report.selfIntersections, 0) << seed;
        EXPECT_EQ(report.changes.gaps, 2) << seed;
        EXPECT_EQ(report.changes.holesFilled, 2) << seed;
    }
}

TEST(Closing, adds_no_more_than_there_is_room_for)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 4);
    GrowingNetwork network(mesh, Box3({0, 0, 0}, {4, 4, 1}), GrowthParameters{});
    for (int i = 0; i < 10; ++i)
        network.countSignal(12, {2, 2, 0.1}); // the middle is the most active, and counts twice
    Closing closing(network, 40);
    closing.judgeSheets();
    EXPECT_EQ(closing.vertexCount(), 34);
    EXPECT_EQ(closing.addVertex(6), 2);
    EXPECT_EQ(closing.addVertex(1), 1);
    EXPECT_EQ(closing.vertexCount(), 37);
}

/// Of a wall that was not scanned at its edges, the start has faces there, which no sample is near
/// to. A web it would be if a surface were missing behind it; but the sides are there, and what is
/// laid onto them crosses them.
TEST(Closing, two_sides_of_a_wall_stay_whole)
{
    Random random(2);
    WorldPoints points;
    for (int i = 0; i < 4000; ++i) {
        const vcg::Point3d p = test::inUnitCube(random);
        points.emplace_back(p.X(), p.Y(), 0.1 * p.X() + (i % 2 == 0 ? 0 : 0.06));
    }
    const PointCloudSampler sampler(points);
    NeuralMesh mesh;
    const GrowthReport report = grow(mesh, sampler, closed(1100, 2));
    EXPECT_EQ(report.selfIntersections, 0); // 31 if the filling counts samples of what is beside it
    EXPECT_GT(report.coverage, 0.999);
}

/// A hair of points from the border of the sheet outwards, too long and thin for a surface.
TEST(Borders, do_not_follow_strays)
{
    // One by one and by batches.
    for (const SplitRule rule : {SplitRule::paper, SplitRule::balanced})
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
            WorldPoints points = sheet(5000);
            Random random(seed);
            for (int i = 0; i < 30; ++i) {
                const vcg::Point3d p = test::inUnitCube(random);
                points.emplace_back(1 + 0.4 * p.X(), 0.5 + 0.02 * p.Y(), 0.1 + 0.01 * p.Z());
            }
            const PointCloudSampler sampler(points);
            GrowthParameters parameters = closed(1000, seed);
            parameters.boundaries = BoundaryRule::open;
            parameters.splitRule = rule;
            NeuralMesh mesh;
            EXPECT_LT(grow(mesh, sampler, parameters).unsupportedArea, 0.06) << seed;
        }
}

/// What the start has beyond the border would have to go while the network grows.
TEST(Borders, of_the_start_are_those_of_the_points)
{
    const PointCloudSampler sampler(sheet(20000));
    GrowthParameters parameters = closed(2000, 1);
    parameters.boundaries = BoundaryRule::open;
    NeuralMesh mesh;
    EXPECT_LT(grow(mesh, sampler, parameters).collapseCount, 240);
}

} // namespace
} // namespace neuralmesh
