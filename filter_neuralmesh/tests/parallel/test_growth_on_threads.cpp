// SPDX-License-Identifier: GPL-3.0-or-later
// Whole runs on several threads, small enough for the thread sanitizer.
#include <gtest/gtest.h>

#include <thread>

#include "core/growth.h"
#include "core/mesh/mesh_checks.h"
#include "neuralmesh/errors.h"
#include "tests/meshes_for_tests.h"
#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

/// Enough vertices for several chunks of 512.
constexpr int target = 600;

class Ball : public test::FixedPoints {
public:
    Ball() : FixedPoints(points()) {}
    std::size_t pointCount() const override { return count; }

private:
    static constexpr std::size_t count = 3000;

    static std::vector<Point3> points()
    {
        std::vector<Point3> made;
        for (const vcg::Point3d &p : test::spherePoints(count, 1))
            made.push_back(p * 0.3);
        return made;
    }
};

const Sampler &ball()
{
    static const Ball sampler;
    return sampler;
}

GrowthParameters onThreads(int threads, Topology topology)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = target;
    parameters.signalsPerSplit = 20;
    parameters.threads = threads;
    parameters.topology = topology;
    parameters.snapshots = {530};
    return parameters;
}

std::vector<Point3> grown(int threads, Topology topology)
{
    NeuralMesh mesh;
    std::vector<Point3> positions;
    const auto add = [&](const NeuralMesh &made) {
        for (const NeuralVertex &vertex : made.vert)
            if (!vertex.IsD())
                positions.push_back(vertex.cP());
    };
    grow(mesh, ball(), onThreads(threads, topology), {},
         [&](const std::unique_ptr<NeuralMesh> &snapshot) { add(*snapshot); });
    add(mesh);
    return positions;
}

TEST(GrowthOnThreads, is_the_same_for_any_number_with_snapshots)
{
    for (const Topology topology : {Topology::ofStart, Topology::learned}) {
        const std::vector<Point3> alone = grown(1, topology);
        EXPECT_EQ(alone.size(), std::size_t(target) + 530);
        EXPECT_EQ(grown(4, topology), alone);
    }
}

TEST(GrowthOnThreads, two_runs_at_once_know_nothing_of_each_other)
{
    const std::vector<Point3> alone = grown(1, Topology::learned);
    std::vector<Point3> other;
    std::thread thread([&] { other = grown(2, Topology::learned); });
    EXPECT_EQ(grown(3, Topology::learned), alone);
    thread.join();
    EXPECT_EQ(other, alone);
}

TEST(GrowthOnThreads, is_cancelled_and_ends_in_time_in_the_middle_of_a_loop)
{
    // Far more calls than there are batches: most are within a loop.
    for (const int call : {50, 1000}) {
        int calls = 0;
        const auto isThere = [&] { return calls >= call; };
        const Progress cancelling([&](double, const char *) { return ++calls < call; });
        NeuralMesh mesh;
        const GrowthParameters parameters = onThreads(4, Topology::learned);
        EXPECT_THROW(grow(mesh, ball(), parameters, cancelling), Cancelled);
        calls = 0;
        const Progress ending([&](double, const char *) { return ++calls > 0; }, isThere);
        NeuralMesh soFar;
        EXPECT_FALSE(grow(soFar, ball(), parameters, ending).reachedTarget);
        validate(soFar);
    }
}

} // namespace
} // namespace neuralmesh
