// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/batch_learning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/network/growing_network.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

constexpr Scalar everywhere = std::numeric_limits<Scalar>::max();
constexpr BatchRules plain{false, everywhere};
constexpr BatchRules byDistance{true, everywhere};

class BatchOnSquare : public ::testing::Test {
protected:
    BatchOnSquare() { test::makeSquare(mesh_, 4); }

    BatchLearning learning() { return {mesh_, Box3({0, 0, -10}, {4, 4, 10}), workers_}; }

    static constexpr VertexId middle = 12;
    NeuralMesh mesh_;
    Workers workers_;
};

TEST_F(BatchOnSquare, a_vertex_moves_as_far_towards_its_samples_as_it_would_one_by_one)
{
    GrowthParameters parameters;
    BatchLearning learning = this->learning();
    const Point3 sample(2, 2, 0.3);
    learning.win(std::vector<Point3>(5, sample), plain);
    Point3 oneByOne = mesh_.position(middle);
    for (int i = 0; i < 5; ++i)
        oneByOne += (sample - oneByOne) * parameters.winnerRate;
    EXPECT_NEAR((learning.move(parameters)[middle] - oneByOne).Norm(), 0, 1e-15);
}

TEST_F(BatchOnSquare, its_neighbours_are_smoothed_once_for_all_that_it_wins)
{
    // Of all vertices but the middle one none wins, and of its neighbours one is off its place.
    mesh_.position(13) += Point3(0.2, 0, 0);
    GrowthParameters parameters;
    BatchLearning learning = this->learning();
    learning.win(std::vector<Point3>(2, {2, 2, 0}), plain);
    const std::vector<Point3> &moved = learning.move(parameters);
    const double share = 1 - std::pow(1 - parameters.smoothingRate, 2 * parameters.smoothingPasses);
    EXPECT_NEAR(moved[13].X(), 3.2 - 0.2 * share, 1e-12);
    EXPECT_NEAR(moved[13].Z(), 0, 1e-15);
    EXPECT_EQ(moved[middle], mesh_.position(middle));
    EXPECT_EQ(moved[0], mesh_.position(0)); // no neighbour of it
    // Half-way at the most, since neighbours move at the same time.
    learning.win(std::vector<Point3>(100, {2, 2, 0}), plain);
    EXPECT_NEAR(learning.move(parameters)[13].X(), 3.1, 1e-12);
}

TEST_F(BatchOnSquare, smoothing_keeps_a_vertex_in_its_tangent_plane_and_on_its_boundary)
{
    for (VertexId v = 0; v < mesh_.idBound(); ++v) {
        const Point3 p = mesh_.position(v);
        mesh_.position(v).Z() = 0.5 * p.X() * p.X();
    }
    BatchLearning learning = this->learning();
    std::vector<Point3> samples;
    for (VertexId v = 0; v < mesh_.idBound(); ++v)
        samples.push_back(mesh_.position(v));
    learning.win(samples, plain);
    const std::vector<Point3> &moved = learning.move({});
    EXPECT_NEAR(moved[middle].Y(), mesh_.position(middle).Y(), 1e-12);
    EXPECT_GT(moved[10].Y(), 1.99); // (0, 2): its neighbours along the boundary hold it
    EXPECT_NEAR(moved[10].X(), 0, 1e-12);
    EXPECT_NEAR(moved[10].Z(), 0, 1e-12);
}

TEST_F(BatchOnSquare, signals_count_by_distance_up_to_a_limit)
{
    BatchLearning learning = this->learning();
    // Above vertices that are no neighbours. The mean root of the distances is 0.2.
    const std::vector<Point3> samples{{1, 1, 0.01}, {3, 1, 0.04}, {1, 3, 0.09}, {3, 3, 0.04}};
    const std::vector<Wins> &wins = learning.win(samples, byDistance);
    EXPECT_NEAR(wins[6].activity, 0.25 + 0.75 / 2, 1e-12);
    EXPECT_NEAR(wins[8].activity, 1, 1e-12);
    EXPECT_NEAR(wins[16].activity, 0.25 + 0.75 * 1.5, 1e-12);
    EXPECT_EQ(wins[6].signals, 1);
    EXPECT_EQ(learning.win(samples, plain)[6].activity, 1);
    std::vector<Point3> far(99, {1, 1, 0.01});
    far.emplace_back(3, 3, 9);
    EXPECT_NEAR(learning.win(far, byDistance)[18].activity, 0.25 + 0.75 * 4, 1e-12);
}

TEST_F(BatchOnSquare, signals_count_one_where_no_sample_is_off_the_surface)
{
    // A starting mesh that is given may have a vertex just where the samples are.
    BatchLearning learning = this->learning();
    EXPECT_EQ(learning.win({{1, 1, 0}, {1, 1, 0}}, byDistance)[6].activity, 2);
}

TEST_F(BatchOnSquare, samples_far_beyond_a_border_are_passed_over)
{
    BatchLearning learning = this->learning();
    const std::vector<Point3> samples{{-1.4, 2, 0}, {-1.6, 2, 0}, {2, 2, 3}};
    const std::vector<Wins> &wins = learning.win(samples, {false, 1.5});
    EXPECT_EQ(wins[10].signals, 1);
    EXPECT_EQ(wins[middle].signals, 1); // inside, there is no such limit
}

TEST(BatchLearning, is_the_same_for_any_number_of_threads)
{
    const auto positionsWith = [](int threads) {
        NeuralMesh mesh;
        test::makeFlatTorus(mesh, 60, 20);
        Box3 bounds;
        std::vector<Point3> samples;
        for (const NeuralVertex &vertex : mesh.vert) {
            bounds.Add(vertex.cP());
            for (const Scalar shift : {0.1, 0.03, -0.07})
                samples.push_back(vertex.cP() + Point3(shift, shift * shift, -shift / 3));
        }
        Workers workers(threads);
        GrowingNetwork network(mesh, bounds, {}, &workers);
        network.learn(samples, everywhere);
        network.learn(samples, everywhere);
        std::vector<Point3> positions;
        for (const NeuralVertex &vertex : mesh.vert)
            positions.push_back(vertex.cP());
        return positions;
    };
    const std::vector<Point3> alone = positionsWith(1);
    EXPECT_EQ(positionsWith(2), alone);
    EXPECT_EQ(positionsWith(5), alone);
}

} // namespace
} // namespace neuralmesh
