// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/density_weights.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "samplers/points/order_of_points.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

std::vector<double> weightsOf(const test::WorldPoints &points)
{
    return weightsByDensity(points.size(), [&](std::uint64_t i) { return toPlain(points[i]); });
}

double mean(const std::vector<double> &weights, std::size_t first, std::size_t end)
{
    const auto begin = weights.begin();
    return std::accumulate(begin + static_cast<std::ptrdiff_t>(first),
                           begin + static_cast<std::ptrdiff_t>(end), 0.0) /
           static_cast<double>(end - first);
}

void addSquare(test::WorldPoints &points, int count, double x)
{
    Random random(1);
    for (int i = 0; i < count; ++i)
        points.emplace_back(x + random.unit(), random.unit(), 0);
}

/// A unit square of 4,000 points beside four of 250 each, which are four times as far apart.
test::WorldPoints unevenSquares()
{
    test::WorldPoints points;
    addSquare(points, 4000, 0);
    for (int square = 1; square <= 4; ++square)
        addSquare(points, 250, square);
    return points;
}

TEST(DensityWeights, there_are_none_where_the_density_is_even)
{
    EXPECT_TRUE(weightsOf(test::spherePoints(5000, 1)).empty());
    EXPECT_TRUE(weightsOf(test::spherePoints(60000, 1)).empty());
    EXPECT_TRUE(weightsOf(test::spherePoints(500, 1)).empty());
}

TEST(DensityWeights, are_the_spacing_to_the_power_of_two_thirds)
{
    const std::vector<double> weights = weightsOf(unevenSquares());
    ASSERT_EQ(weights.size(), 5000U);
    EXPECT_NEAR(mean(weights, 4000, 5000) / mean(weights, 0, 4000), std::pow(4, 2.0 / 3), 0.2);
}

TEST(DensityWeights, a_stray_weighs_what_those_do_that_it_is_near_to)
{
    test::WorldPoints points = unevenSquares();
    for (int i = 1; i <= 5; ++i)
        points.emplace_back(0.15 * i, 0.5, 0.2); // twelve spacings off
    const std::vector<double> weights = weightsOf(points);
    EXPECT_LT(mean(weights, 5000, 5005), 1.2 * mean(weights, 0, 4000));
}

TEST(DensityWeights, points_at_one_place_weigh_as_one)
{
    test::WorldPoints points = test::spherePoints(2000, 1);
    points.insert(points.begin() + 1000, 300, points[1000]);
    const std::vector<double> weights = weightsOf(points);
    ASSERT_EQ(weights.size(), 2300U);
    EXPECT_EQ(mean(weights, 0, 1000), 1);
    EXPECT_NEAR(mean(weights, 1000, 1301), 1.0 / 301, 1e-9);
    EXPECT_EQ(mean(weights, 1301, 2300), 1);
}

TEST(OrderOfPoints, each_point_of_a_run_is_as_likely_as_it_weighs)
{
    // Ten points on a line in three runs: of three, three and four.
    const auto pointAt = [](std::size_t i) { return Point{0.1 * static_cast<double>(i), 0, 0}; };
    OrderOfPoints order(10, {{0, 0, 0}, {1, 0, 0}}, pointAt);
    order.weigh({1, 0, 2});
    Random random(3);
    std::vector<int> times(10, 0);
    for (int i = 0; i < 2000; ++i)
        for (std::size_t stratum = 0; stratum < 11; ++stratum)
            ++times[order.draw(random, stratum, 11)];
    // A stratum is as long as a point of the first run weighs.
    for (std::size_t i = 0; i < 10; ++i)
        EXPECT_NEAR(times[i], i < 3 ? 2000 : i < 6 ? 0 : 4000, i < 3 ? 0 : 200) << i;
}

} // namespace
} // namespace neuralmesh
