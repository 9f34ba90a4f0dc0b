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

/// Upwards.
vcg::Point3f normalOfPlate(const Point3 &p)
{
    return vcg::Point3f::Construct(
        Point3(-0.6 * std::cos(3 * p.X()) * p.Y(), -0.2 * std::sin(3 * p.X()), 1));
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

using Normals = std::vector<vcg::Point3f>;

/// Of each kind of points, of so many kinds that take turns, the share of inner sides.
std::vector<double> innerShares(const test::Points &points, const Normals &normals,
                                std::size_t kinds)
{
    const InnerSides sides(points, normals, radius, 0);
    std::vector<double> shares(kinds, 0);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (sides.hasPoint(i))
            shares[i % kinds] += static_cast<double>(kinds) / static_cast<double>(points.size());
    return shares;
}

TEST(InnerSides, are_those_behind_others_along_their_normals)
{
    const test::Points points = plate(0.03, 0.004, 30000); // its upper side first
    for (const float up : {1.0F, -0.5F}) {
        Normals normals;
        for (const Point3 &p : points)
            normals.push_back(normalOfPlate(p) * up);
        const std::vector<double> share = innerShares(points, normals, 2);
        EXPECT_GT(share[up > 0 ? 1 : 0], 0.95) << up;
        EXPECT_EQ(share[up > 0 ? 0 : 1], 0) << up;
    }
}

TEST(InnerSides, of_walls_with_a_gap_between_them_there_are_none)
{
    // Upper sides look down, lower ones up.
    const test::Points points = plate(0.03, 0, 30000);
    Normals normals;
    for (std::size_t i = 0; i < points.size(); ++i)
        normals.push_back(normalOfPlate(points[i]) * (i % 2 == 0 ? -1.0F : 1.0F));
    EXPECT_EQ(innerShares(points, normals, 1)[0], 0);
}

TEST(InnerSides, of_a_sheet_with_noise_there_are_none)
{
    const test::Points points = plate(0, 0.01, 30000);
    EXPECT_LT(innerShares(points, Normals(points.size(), {0, 0, 1}), 1)[0], 0.001);
}

} // namespace
} // namespace neuralmesh
