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

TEST(TwoSides, of_a_plate_are_found_as_long_as_noise_is_less_than_half_their_distance)
{
    for (const double thickness : {0.01, 0.02, 0.04})
        for (const double noise : {0.0, 0.12, 0.25})
            EXPECT_TRUE(haveTwoSides(plate(thickness, noise * thickness), radius))
                << thickness << " " << noise;
    EXPECT_FALSE(haveTwoSides(plate(0.02, 0.02), radius));
}

TEST(TwoSides, of_a_sheet_there_are_none_whatever_its_noise)
{
    for (const double noise : {0.0, 0.001, 0.005, 0.02})
        EXPECT_FALSE(haveTwoSides(plate(0, noise), radius)) << noise;
    EXPECT_FALSE(haveTwoSides(plate(0, 0.01, 1500), radius));
}

TEST(TwoSides, of_points_on_a_plane_or_too_few_to_tell_there_are_none)
{
    test::Points flat;
    Random random(1);
    for (int i = 0; i < 3000; ++i)
        flat.emplace_back(random.unit(), random.unit(), 0);
    EXPECT_FALSE(haveTwoSides(flat, radius));
    EXPECT_FALSE(haveTwoSides(plate(0.02, 0, 300), radius));
}

} // namespace
} // namespace neuralmesh
