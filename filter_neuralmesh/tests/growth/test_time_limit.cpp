// SPDX-License-Identifier: GPL-3.0-or-later
// Runs whose time is up: the mesh so far is as sound as any.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "core/growth.h"
#include "core/mesh/boundary.h"
#include "core/mesh/mesh_checks.h"
#include "neuralmesh/deadline.h"
#include "neuralmesh/errors.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"
#include "tests/points_for_tests.h"
#include "tests/shapes_for_tests.h"

namespace neuralmesh {
namespace {

constexpr int target = 300;

GrowthParameters parametersFor(Topology topology = Topology::learned)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = target;
    parameters.topology = topology;
    parameters.threads = 1;
    return parameters;
}

/// What comes of a run whose time is up from a report on.
struct ShortRun {
    NeuralMesh mesh;
    GrowthReport report;
    std::vector<int> snapshots;
    int calls = 0;

    /// `isLast` tells that report by its number, from 1, its share of the work and its activity.
    template <class IsLast>
    ShortRun(const Sampler &sampler, const GrowthParameters &parameters, const IsLast &isLast)
    {
        bool isUp = false;
        const Progress progress(
            [&](double fraction, const char *activity) {
                isUp = isUp || isLast(++calls, fraction, activity);
                return true;
            },
            [&] { return isUp; });
        report = grow(mesh, sampler, parameters, progress,
                      [&](const std::unique_ptr<NeuralMesh> &snapshot) {
                          validate(*snapshot);
                          snapshots.push_back(snapshot->vn);
                      });
        validate(mesh);
        EXPECT_EQ(mesh.fn, static_cast<int>(mesh.face.size()));
        EXPECT_EQ(report.reachedTarget, report.timeUp == TimeUp::no);
        EXPECT_TRUE(std::isfinite(report.rmsError));
    }
};

auto atCall(int number)
{
    return [number](int call, double, const char *) { return call == number; };
}

auto within(const char *activity, double share = 0)
{
    return [activity, share](int, double fraction, const char *now) {
        return std::strcmp(now, activity) == 0 && fraction >= share;
    };
}

const PointCloudSampler &ball()
{
    static const PointCloudSampler sampler(test::spherePoints(5000, 1));
    return sampler;
}

TEST(TimeLimit, leaves_a_closed_mesh_of_one_part_wherever_it_falls)
{
    for (const Topology topology : {Topology::ofStart, Topology::learned}) {
        const GrowthParameters parameters = parametersFor(topology);
        const int all = ShortRun(ball(), parameters, atCall(-1)).calls;
        ASSERT_GT(all, 100);
        for (int call = 1; call <= all; call += 1 + all / 15) {
            const ShortRun run(ball(), parameters, atCall(call));
            EXPECT_TRUE(isClosed(run.mesh)) << call;
            EXPECT_EQ(measureTopology(run.mesh).components, 1) << call;
            EXPECT_GT(signedVolume(run.mesh), 0) << call;
            EXPECT_LE(run.mesh.vn, target) << call;
        }
    }
}

TEST(TimeLimit, gives_the_tetrahedron_before_the_shape_is_read)
{
    const ShortRun run(ball(), parametersFor(), atCall(1));
    EXPECT_EQ(run.mesh.vn, 4);
    EXPECT_EQ(run.report.changes.shape, LearnedShape::notFinished);
    EXPECT_EQ(run.report.timeUp, TimeUp::inGrowth);
}

TEST(TimeLimit, gives_the_tetrahedron_of_points_on_a_plane_too)
{
    test::WorldPoints plane;
    for (int i = 0; i < 2500; ++i)
        plane.emplace_back(i % 50, i / 50, 0);
    const PointCloudSampler sampler(plane);
    const ShortRun run(sampler, parametersFor(), atCall(1));
    EXPECT_EQ(run.mesh.vn, 4);
    EXPECT_GT(signedVolume(run.mesh), 0);
}

TEST(TimeLimit, ends_growth_with_the_vertices_that_there_are)
{
    const ShortRun run(ball(), parametersFor(Topology::ofStart),
                       within("Growing the network", 0.4));
    EXPECT_EQ(run.report.timeUp, TimeUp::inGrowth);
    EXPECT_GT(run.mesh.vn, 0.35 * target); // growth has 0.85 of the work
    EXPECT_LT(run.mesh.vn, 0.6 * target);
    EXPECT_GT(run.report.coverage, 0.99);
}

TEST(TimeLimit, ends_the_fit_with_all_vertices)
{
    const ShortRun run(ball(), parametersFor(), within("Fitting the surface"));
    EXPECT_EQ(run.report.timeUp, TimeUp::inSurfaceFit);
    EXPECT_EQ(run.mesh.vn, target);
    const ShortRun whole(ball(), parametersFor(), atCall(-1));
    EXPECT_TRUE(whole.report.reachedTarget);
    EXPECT_LT(whole.report.rmsError, 0.5 * run.report.rmsError);
}

TEST(TimeLimit, keeps_the_snapshots_that_were_taken_and_none_that_is_not_finished)
{
    GrowthParameters parameters = parametersFor(Topology::ofStart);
    parameters.snapshots = {50, 150, 250};
    const ShortRun whole(ball(), parameters, atCall(-1));
    ASSERT_EQ(whole.snapshots, parameters.snapshots);
    std::size_t most = 0;
    std::size_t fewest = 3;
    for (int call = 1; call <= whole.calls; call += 1 + whole.calls / 25) {
        const ShortRun run(ball(), parameters, atCall(call));
        most = std::max(most, run.snapshots.size());
        fewest = std::min(fewest, run.snapshots.size());
        for (std::size_t i = 0; i < run.snapshots.size(); ++i)
            EXPECT_EQ(run.snapshots[i], parameters.snapshots[i]) << call;
    }
    EXPECT_EQ(fewest, 0U);
    EXPECT_EQ(most, 3U);
}

TEST(TimeLimit, closes_what_grows_open)
{
    Random random(3);
    test::WorldPoints tube;
    for (int i = 0; i < 6000; ++i) {
        const double angle = 2 * M_PI * random.unit();
        tube.emplace_back(std::cos(angle), std::sin(angle), 4 * random.unit());
    }
    const PointCloudSampler sampler(tube);
    const ShortRun run(sampler, parametersFor(), within("Growing the network", 0.6));
    EXPECT_EQ(run.report.timeUp, TimeUp::inGrowth);
    EXPECT_EQ(run.report.changes.shape, LearnedShape::found);
    EXPECT_TRUE(isClosed(run.mesh));
}

TEST(TimeLimit, changes_nothing_while_there_is_time)
{
    const ShortRun limited(ball(), parametersFor(), atCall(-1));
    NeuralMesh free;
    grow(free, ball(), parametersFor());
    ASSERT_EQ(free.vn, limited.mesh.vn);
    for (VertexId v = 0; v < free.idBound(); ++v)
        if (free.isLive(v)) {
            EXPECT_EQ(free.position(v), limited.mesh.position(v));
        }
}

TEST(Deadline, passes_after_its_seconds_and_not_before)
{
    EXPECT_FALSE(Deadline().hasPassed());
    EXPECT_FALSE(Deadline::in(0).hasPassed());
    EXPECT_FALSE(Deadline::in(1000).hasPassed());
    EXPECT_FALSE(Deadline::in(std::numeric_limits<double>::infinity()).hasPassed());
    const auto begin = std::chrono::steady_clock::now();
    const Deadline soon = Deadline::in(0.01);
    while (!soon.hasPassed())
        ;
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(10));
}

TEST(Deadline, refuses_what_is_no_length_of_time)
{
    for (const double seconds : {-1.0, -1e-300, std::numeric_limits<double>::quiet_NaN()})
        try {
            Deadline::in(seconds);
            FAIL();
        } catch (const InvalidParameter &error) {
            EXPECT_EQ(error.parameter(), Parameter::timeLimit);
            EXPECT_EQ(std::string(error.what()).rfind("timeLimit must be at least 0, not ", 0), 0U);
        }
}

} // namespace
} // namespace neuralmesh
