// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/two_sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

/// Of two sides of the unit square, bent, with noise of that amplitude: a sum of three uniform
/// numbers, whose standard deviation is the amplitude.
test::Points plate(double thickness, double noise, int count = 8000)
{
    Random random(3);
    test::Points points;
    for (int i = 0; i < count; ++i) {
        const double x = random.unit();
        const double y = random.unit();
        const double z = 0.2 * std::sin(3 * x) * y + (i % 2 == 0 ? 0.5 : -0.5) * thickness;
        const double stray = 2 * (random.unit() + random.unit() + random.unit() - 1.5);
        points.emplace_back(x, y, z + stray * noise);
    }
    return points;
}

constexpr double radius = 2.6 / 32; // two cells of the first grid around the square

bool haveTwoSides(const test::Points &points, double leastThickness = 0)
{
    return neuralmesh::haveTwoSides(points, radius, leastThickness);
}

TEST(TwoSides, of_a_plate_are_found_as_long_as_noise_is_less_than_half_their_distance)
{
    for (const double thickness : {0.015, 0.02, 0.04})
        for (const double noise : {0.0, 0.12, 0.25})
            EXPECT_TRUE(haveTwoSides(plate(thickness, noise * thickness, 30000)))
                << thickness << " " << noise;
    EXPECT_FALSE(haveTwoSides(plate(0.03, 0.03, 30000)));
}

/// In a half turn, whose sag within the radius is twice its thickness.
TEST(TwoSides, of_a_bent_plate_are_found)
{
    Random random(1);
    test::Points points;
    for (int i = 0; i < 60000; ++i) {
        const double angle = M_PI * random.unit();
        const double r = 0.12 + (i % 2 == 0 ? 0.0075 : -0.0075);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), random.unit());
    }
    EXPECT_TRUE(haveTwoSides(points));
}

TEST(TwoSides, of_a_sheet_there_are_none_whatever_its_noise)
{
    for (const double noise : {0.0, 0.001, 0.005, 0.02})
        EXPECT_FALSE(haveTwoSides(plate(0, noise))) << noise;
    EXPECT_FALSE(haveTwoSides(plate(0, 0.01, 1500)));
}

/// A uniform distribution is the one most like two peaks.
TEST(TwoSides, of_heights_with_one_peak_there_are_none)
{
    const auto uniform = [](double, double, Random &random) { return 0.03 * random.unit(); };
    for (const std::uint64_t seed : {1U, 2U, 3U})
        EXPECT_FALSE(haveTwoSides(test::pointsOverSquare(60000, seed, uniform))) << seed;
}

TEST(TwoSides, that_are_too_near_are_none)
{
    const test::Points thin = plate(0.01, 0, 60000);
    EXPECT_TRUE(haveTwoSides(thin, 0.009));
    EXPECT_FALSE(haveTwoSides(thin, 0.011));
    // 1.6 spacings
    EXPECT_FALSE(haveTwoSides(plate(0.01, 0, 25000)));
}

TEST(TwoSides, of_points_on_a_plane_or_too_few_to_tell_there_are_none)
{
    const test::Points flat =
        test::pointsOverSquare(3000, 1, [](double, double, Random &) { return 0; });
    EXPECT_FALSE(haveTwoSides(flat));
    EXPECT_FALSE(haveTwoSides(plate(0.2, 0, 200)));
}

} // namespace
} // namespace neuralmesh
