// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/growth.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

const test::WorldPoints &densePointsOnSphere()
{
    static const test::WorldPoints points = test::spherePoints(200000, 7);
    return points;
}

GrowthParameters withTarget(int target)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = target;
    return parameters;
}

struct ValenceShares {
    double six, fiveToSeven; ///< per cent
};

ValenceShares valenceShares(const NeuralMesh &mesh)
{
    std::vector<int> histogram = valenceHistogram(mesh);
    histogram.resize(std::max<std::size_t>(histogram.size(), 8));
    const double all = mesh.vn / 100.0;
    return {histogram[6] / all, (histogram[5] + histogram[6] + histogram[7]) / all};
}

TEST(Growth, gives_a_closed_sphere_of_exactly_the_vertices_asked_for)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    for (const int target : {4, 5, 17, 100, 1234}) {
        GrowthParameters parameters = withTarget(target);
        parameters.topology = Topology::ofStart;
        NeuralMesh mesh;
        const GrowthReport report = grow(mesh, sampler, parameters);
        validate(mesh);
        const TopologyFigures topology = measureTopology(mesh);
        EXPECT_TRUE(report.reachedTarget);
        EXPECT_EQ(topology.vertices, target);
        EXPECT_EQ(topology.faces, 2 * target - 4);
        EXPECT_EQ(mesh.fn, 2 * target - 4);
        EXPECT_EQ(topology.genus, 0);
        EXPECT_EQ(topology.components, 1);
        EXPECT_GT(signedVolume(mesh), 0);
        EXPECT_EQ(4 + report.splitCount - report.collapseCount, static_cast<std::uint64_t>(target));
    }
}

TEST(Growth, from_the_data_gives_exactly_the_vertices_asked_for_too)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    for (const int target : {4, 5, 17, 100, 1234}) {
        NeuralMesh mesh;
        grow(mesh, sampler, withTarget(target));
        validate(mesh);
        EXPECT_EQ(mesh.vn, target);
        EXPECT_EQ(mesh.fn, 2 * target - 4);
        EXPECT_GT(signedVolume(mesh), 0);
    }
}

TEST(Growth, comes_near_the_sphere_it_samples)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    NeuralMesh mesh;
    grow(mesh, sampler, withTarget(1000));
    for (const NeuralFace &face : mesh.face)
        // A face of 1,000 vertices spans about 0.12. The fit puts its corners outside by about its
        // sagitta, 0.12^2 / 2 / 3 = 0.0024, and 0.0033 to 0.0043 at most, of three seeds.
        EXPECT_NEAR(toWorld(sampler.frame(), face.cP(0)).Norm(), 1, 0.006);
}

TEST(Growth, the_same_seed_gives_the_same_mesh_and_another_seed_another)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    const auto positions = [&](std::uint64_t seed) {
        GrowthParameters parameters = withTarget(500);
        parameters.seed = seed;
        NeuralMesh mesh;
        grow(mesh, sampler, parameters);
        std::vector<Point3> all;
        for (const NeuralFace &face : mesh.face)
            for (int corner = 0; corner < 3; ++corner)
                all.push_back(face.cP(corner));
        return all;
    };
    EXPECT_EQ(positions(1), positions(1)); // bit for bit
    EXPECT_NE(positions(1), positions(2));
}

TEST(Growth, is_the_same_for_any_number_of_threads)
{
    // Enough vertices for several chunks of each loop, and for a grid of 64 cells.
    const PointCloudSampler sampler(densePointsOnSphere());
    const auto grown = [&](int threads) {
        GrowthParameters parameters = withTarget(3000);
        parameters.threads = threads;
        NeuralMesh mesh;
        const GrowthReport report = grow(mesh, sampler, parameters);
        std::vector<Point3> positions;
        for (const NeuralVertex &vertex : mesh.vert)
            if (!vertex.IsD())
                positions.push_back(vertex.cP());
        positions.emplace_back(report.rmsError, report.maxError, report.unsupportedArea);
        return positions;
    };
    const std::vector<Point3> alone = grown(1);
    EXPECT_EQ(grown(2), alone);
    EXPECT_EQ(grown(5), alone);
}

TEST(Growth, reproduces_table_1_with_the_papers_split_and_a_long_memory)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    for (const int target : {1000, 5000}) {
        GrowthParameters parameters = withTarget(target);
        parameters.topology = Topology::ofStart;
        parameters.splitRule = SplitRule::paper;
        parameters.edgeFlips = false;
        parameters.surfaceFit = false;
        NeuralMesh mesh;
        grow(mesh, sampler, parameters);
        const ValenceShares shares = valenceShares(mesh);
        // The paper's Table 1: 94.9 to 95.9 % and 44.9 to 49.0 %. scripts/reproduce_paper.py
        // measures 93.5 to 95.6 % and 42.8 to 46.2 % on the sphere.
        EXPECT_GE(shares.fiveToSeven, 92) << target;
        EXPECT_GE(shares.six, 40) << target;
    }
}

TEST(Growth, makes_even_valences_by_default_whatever_the_size)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    double least = 100, most = 0;
    for (const int target : {1000, 2000, 5000}) {
        NeuralMesh mesh;
        grow(mesh, sampler, withTarget(target));
        const ValenceShares shares = valenceShares(mesh);
        // 99.98 to 100 % and 72.2 to 74.7 %, of three seeds; without exchanges 99.7 to 99.94 %.
        EXPECT_GE(shares.fiveToSeven, 99.97) << target;
        EXPECT_GE(shares.six, 70) << target;
        least = std::min(least, shares.six);
        most = std::max(most, shares.six);
    }
    EXPECT_LT(most - least, 3);
}

TEST(Growth, refuses_a_target_above_the_distinct_points_and_names_the_most)
{
    const PointCloudSampler sampler(test::spherePoints(300, 1));
    NeuralMesh mesh;
    try {
        grow(mesh, sampler, withTarget(301));
        FAIL() << "301 vertices from 300 points were accepted";
    } catch (const InvalidInput &error) {
        EXPECT_NE(std::string(error.what()).find("at most 300"), std::string::npos);
    }
}

TEST(Growth, says_that_points_on_a_plane_are_not_all)
{
    test::WorldPoints points;
    for (int i = 0; i < 900; ++i)
        points.emplace_back(i % 30, i / 30, 0);
    points.emplace_back(15, 15, 900);
    const PointCloudSampler sampler(points);
    GrowthParameters parameters;
    parameters.targetVertexCount = 10;
    parameters.topology = Topology::ofStart;
    NeuralMesh mesh;
    try {
        grow(mesh, sampler, parameters);
        FAIL();
    } catch (const FlatTarget &error) {
        EXPECT_EQ(error.ignored(), 1U);
        EXPECT_STREQ(error.what(),
                     "All points but 1 isolated one lie on a plane: a closed surface cannot be "
                     "fitted to them. Learn the topology from the data.");
    }
}

TEST(Growth, makes_as_many_vertices_as_there_are_points)
{
    const PointCloudSampler sampler(test::spherePoints(300, 1));
    NeuralMesh mesh;
    const GrowthReport report = grow(mesh, sampler, withTarget(300));
    validate(mesh);
    EXPECT_EQ(mesh.vn, 300);
    EXPECT_TRUE(report.reachedTarget);
}

TEST(Growth, from_closed_data_takes_fewer_signals_to_settle_than_to_grow)
{
    // Half of the vertices are the start's. The other half takes λ signals each, and so would the
    // start, if it were not near the samples.
    const GrowthParameters parameters = withTarget(1000);
    const PointCloudSampler sampler(densePointsOnSphere());
    NeuralMesh mesh;
    const GrowthReport report = grow(mesh, sampler, parameters);
    EXPECT_LT(static_cast<double>(report.signalCount), 0.75 * 1000 * parameters.signalsPerSplit);
}

TEST(Growth, does_not_replace_vertices_that_are_idle_by_chance)
{
    // Of two points a vertex, an eighth of the vertices wins none, whichever they are. Where these
    // are replaced ten times, by the paper's rules, 1,334 to 1,444 of three seeds, else 186 to 287.
    const PointCloudSampler sampler(test::spherePoints(3000, 1));
    NeuralMesh mesh;
    GrowthParameters parameters = withTarget(1500);
    parameters.splitRule = SplitRule::paper;
    EXPECT_LT(grow(mesh, sampler, parameters).collapseCount, 500);
}

TEST(Growth, keeps_idle_vertices_only_where_it_comes_to_a_stop)
{
    // Removing every vertex that did not win within 2n samples, growth by one in 100 samples has
    // its balance far below 300 vertices.
    GrowthParameters parameters = withTarget(300);
    const PointCloudSampler sampler(densePointsOnSphere());
    NeuralMesh mesh;
    EXPECT_FALSE(grow(mesh, sampler, parameters).keptIdle);
    parameters.inactivityFactor = 2;
    NeuralMesh another;
    EXPECT_TRUE(grow(another, sampler, parameters).keptIdle);
    EXPECT_EQ(another.vn, 300);
}

TEST(Growth, takes_twice_its_signals_at_the_most_where_it_folds)
{
    // A solid can only crumple on a strip with half a twist. It took four times as many.
    const PointCloudSampler sampler(test::moebiusPoints(10000, 1));
    NeuralMesh mesh;
    GrowthParameters parameters = withTarget(1500);
    parameters.topology = Topology::ofStart;
    const GrowthReport report = grow(mesh, sampler, parameters);
    EXPECT_LT(report.signalCount, 2.3 * parameters.signalsPerSplit * mesh.vn);
    EXPECT_TRUE(report.keptIdle);
    EXPECT_EQ(mesh.vn, 1500);
}

TEST(Growth, stops_when_progress_says_so)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    NeuralMesh mesh;
    int calls = 0;
    const Progress stopAtThird = [&](double, const char *) { return ++calls < 3; };
    EXPECT_THROW(grow(mesh, sampler, withTarget(1000), stopAtThird), Cancelled);
    EXPECT_EQ(calls, 3);
}

TEST(Growth, progress_rises_from_nothing_to_all)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    NeuralMesh mesh;
    double last = 0;
    bool rises = true;
    grow(mesh, sampler, withTarget(1000), [&](double fraction, const char *) {
        rises = rises && fraction >= last - 0.02 && fraction <= 1; // collapses take a little back
        last = fraction;
        return true;
    });
    EXPECT_TRUE(rises);
    EXPECT_GT(last, 0.95);
}

GrowthParameters fromTheData(int target)
{
    GrowthParameters parameters = withTarget(target);
    parameters.topology = Topology::learned;
    return parameters;
}

TEST(Growth, progress_rises_from_nothing_to_all_with_a_start_from_the_data)
{
    const PointCloudSampler sampler(test::spherePoints(5000, 1));
    NeuralMesh mesh;
    double last = 0;
    double endOfStart = -1;
    bool rises = true;
    grow(mesh, sampler, fromTheData(1000), [&](double fraction, const char *activity) {
        const bool isStart = std::string(activity) == "Learning the shape";
        rises = rises && fraction >= last - 0.02 && fraction <= 1; // collapses take a little back
        rises = rises && (!isStart || fraction >= endOfStart);     // told again while it works
        last = fraction;
        if (isStart)
            endOfStart = fraction;
        return true;
    });
    EXPECT_TRUE(rises);
    EXPECT_GT(endOfStart, 0); // the start said so
    EXPECT_LT(endOfStart, 0.05);
    EXPECT_GT(last, 0.95);
}

TEST(Growth, stops_within_a_start_from_the_data_when_progress_says_so)
{
    const PointCloudSampler sampler(test::spherePoints(5000, 1));
    // At once, on the first grid, and on a finer one.
    for (const int stopAt : {1, 5, 27}) {
        NeuralMesh mesh;
        int calls = 0;
        std::string stoppedIn;
        const Progress stop = [&](double, const char *activity) {
            stoppedIn = activity;
            return ++calls < stopAt;
        };
        EXPECT_THROW(grow(mesh, sampler, fromTheData(1000), stop), Cancelled);
        EXPECT_EQ(calls, stopAt);
        EXPECT_EQ(stoppedIn, "Learning the shape");
    }
}

TEST(Growth, reports_errors_that_fall_as_the_network_grows)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    for (const Topology topology : {Topology::ofStart, Topology::learned}) {
        GrowthParameters parameters = withTarget(1000);
        parameters.topology = topology;
        NeuralMesh mesh;
        const GrowthReport report = grow(mesh, sampler, parameters);
        ASSERT_EQ(report.convergence.size(), 7U); // at 8, 16, ... 512
        for (std::size_t k = 1; k < report.convergence.size(); ++k)
            EXPECT_LT(report.convergence[k], report.convergence[k - 1]);
        EXPECT_LT(report.rmsError, report.convergence.back());
        EXPECT_GT(report.maxError, report.rmsError);
        EXPECT_LT(report.maxError, 10 * report.rmsError);
    }
}

TEST(Growth, refuses_parameters_out_of_range)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    NeuralMesh mesh;
    const auto refuses = [&](auto change) {
        GrowthParameters parameters = withTarget(100);
        change(parameters);
        EXPECT_THROW(grow(mesh, sampler, parameters), InvalidInput);
    };
    refuses([](GrowthParameters &p) { p.targetVertexCount = 3; });
    refuses([](GrowthParameters &p) { p.winnerRate = 0; });
    refuses([](GrowthParameters &p) { p.winnerRate = std::nan(""); });
    refuses([](GrowthParameters &p) { p.smoothingRate = 1; });
    refuses([](GrowthParameters &p) { p.smoothingPasses = 0; });
    refuses([](GrowthParameters &p) { p.signalsPerSplit = 0; });
    refuses([](GrowthParameters &p) { p.inactivityFactor = 0; });
    refuses([](GrowthParameters &p) { p.counterDecay = 1.5; });
}

TEST(Growth, every_parameter_changes_the_result)
{
    const PointCloudSampler sampler(densePointsOnSphere());
    const auto sumOfPositions = [&](const GrowthParameters &parameters) {
        NeuralMesh mesh;
        grow(mesh, sampler, parameters);
        double sum = 0;
        for (const NeuralVertex &vertex : mesh.vert)
            sum += vertex.IsD() ? 0 : std::abs(vertex.cP().X());
        return sum;
    };
    const double asItIs = sumOfPositions(withTarget(300));
    const auto changes = [&](auto change) {
        GrowthParameters parameters = withTarget(300);
        change(parameters);
        EXPECT_NE(sumOfPositions(parameters), asItIs);
    };
    changes([](GrowthParameters &p) { p.winnerRate = 0.1; });
    changes([](GrowthParameters &p) { p.smoothingRate = 0.1; });
    changes([](GrowthParameters &p) { p.smoothingPasses = 2; });
    changes([](GrowthParameters &p) { p.signalsPerSplit = 50; });
    changes([](GrowthParameters &p) { p.inactivityFactor = 1; });
    changes([](GrowthParameters &p) { p.counterDecay = 0.5; });
    changes([](GrowthParameters &p) { p.splitRule = SplitRule::paper; });
    changes([](GrowthParameters &p) { p.edgeFlips = false; });
    changes([](GrowthParameters &p) { p.surfaceFit = false; });
    changes([](GrowthParameters &p) { p.seed = 9; });
}

} // namespace
} // namespace neuralmesh
