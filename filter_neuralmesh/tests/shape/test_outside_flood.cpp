// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/outside_flood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/points_for_tests.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

constexpr int resolution = 32;
const GridSize cube = test::cube(resolution);
constexpr double reach = 1.5;
const Point3 centre(0.5, 0.5, 0.5);

/// Positive within the ball.
Grid ball(const GridSize &cells, double radius, const Point3 &middle)
{
    return test::sampled(cells, [&](const Point3 &p) { return radius - (p - middle).Norm(); });
}

/// A sphere around the centre, of which the cap above a height, in radii, is missing.
test::Points sphereBelow(double radius, double height, const Point3 &middle = centre)
{
    test::Points points;
    for (const Point3 &p : test::spherePoints(20000, 1))
        if (p.Z() <= height)
            points.push_back(p);
    return test::moved(points, radius, middle);
}

/// A square sheet across the middle of the cube.
test::Points sheet()
{
    Random random(2);
    test::Points points;
    for (int i = 0; i < 20000; ++i) {
        const double x = 0.1 + 0.8 * random.unit();
        points.emplace_back(x, 0.1 + 0.8 * random.unit(), 0.5);
    }
    return points;
}

bool isOutside(const OutsideFlood &flood, const Point3 &place)
{
    const auto node = [&](int axis) {
        return static_cast<int>(std::lround(place[axis] * resolution));
    };
    return flood.outside()[Grid(cube).index(node(0), node(1), node(2))] != 0;
}

TEST(OutsideFlood, surrounds_a_closed_surface_and_leaves_a_crust_free)
{
    constexpr double radius = 0.25;
    // Points are dense: the crust is complete but for the distance of a point and a node.
    constexpr double slack = 0.2;
    for (const GridSize &cells : {cube, GridSize{24, 32, 28}}) {
        const Point3 middle = Point3(cells.x, cells.y, cells.z) / (2 * resolution);
        const Grid inside = ball(cells, radius, middle);
        const OutsideFlood flood(inside, sphereBelow(radius, 1, middle), reach);
        test::forEachNode(inside, [&](int x, int y, int z) {
            const double distance =
                ((Point3(x, y, z) / resolution - middle).Norm() - radius) * resolution;
            const bool outside = flood.outside()[inside.index(x, y, z)] != 0;
            if (distance > reach || distance < reach - slack) {
                EXPECT_EQ(outside, distance > reach) << x << ' ' << y << ' ' << z;
            }
        });
        EXPECT_EQ(flood.doubledShare(), 0);
    }
}

TEST(OutsideFlood, passes_holes_wider_than_twice_the_reach)
{
    // Nothing is taken for inside, so that all that the flood reaches is outside.
    const Grid nowhere(cube, -1);
    constexpr double radius = 0.35;
    for (const bool isWide : {false, true}) {
        const double holeRadius = (isWide ? 1.3 : 0.7) * reach / resolution;
        const double height = std::sqrt(1 - std::pow(holeRadius / radius, 2));
        const OutsideFlood flood(nowhere, sphereBelow(radius, height), reach);
        EXPECT_EQ(isOutside(flood, centre), isWide);
    }
}

TEST(OutsideFlood, leaves_a_ball_whose_hole_a_small_membrane_closes)
{
    // The hole has a sixteenth of the sphere's area, and is wider than the crust.
    constexpr double radius = 0.35;
    const test::Points open = sphereBelow(radius, 1 - 2.0 / 16);
    const OutsideFlood flood(ball(cube, radius, centre), open, reach);
    EXPECT_FALSE(isOutside(flood, centre));
    EXPECT_EQ(flood.doubledShare(), 0);
    EXPECT_TRUE(isOutside(OutsideFlood(Grid(cube, -1), open, reach), centre))
        << "The flood does not pass the hole.";
}

/// A wall of points around the centre, below a height: those of a sphere, each moved along its
/// radius by what move(point's number) says, in cells.
template <class Move> test::Points wall(double radius, double height, const Move &move)
{
    test::Points points;
    int number = 0;
    for (const Point3 &p : test::spherePoints(20000, 1))
        if (p.Z() <= height)
            points.push_back(centre + p * (radius + move(number++) / resolution));
    return points;
}

TEST(OutsideFlood, opens_a_mouth_behind_which_a_second_side_has_points)
{
    // Of the sphere, the same small part is missing; the field closes it by a membrane.
    constexpr double radius = 0.35;
    constexpr double height = 1 - 2.0 / 16;
    constexpr double thickness = 2.5;
    const auto inAndOut = [](int i) { return i % 2 == 0 ? 0 : -thickness; };
    const OutsideFlood flood(ball(cube, radius, centre), wall(radius, height, inAndOut), reach);
    EXPECT_TRUE(isOutside(flood, centre));
    EXPECT_LT(flood.doubledShare(), 0.1); // both sides have points: nothing but the brim is doubled
}

TEST(OutsideFlood, opens_a_mouth_whose_second_side_is_less_than_a_cell_behind)
{
    // As where few points make a thin wall: its surface on the field lies between its sides.
    constexpr double radius = 0.35;
    constexpr double height = 1 - 2.0 / 16;
    const auto inAndOut = [](int i) { return i % 2 == 0 ? 0.2 : -0.8; };
    const OutsideFlood flood(ball(cube, radius, centre), wall(radius, height, inAndOut), reach);
    EXPECT_TRUE(isOutside(flood, centre));
}

TEST(OutsideFlood, leaves_a_ball_of_whose_points_some_lie_a_little_inside)
{
    // Half a cell and more: as many lie as far outside.
    constexpr double radius = 0.35;
    constexpr double height = 1 - 2.0 / 16;
    const auto toBothSides = [](int i) { return 0.8 * std::cos(i); };
    const OutsideFlood flood(ball(cube, radius, centre), wall(radius, height, toBothSides), reach);
    EXPECT_FALSE(isOutside(flood, centre));
}

TEST(OutsideFlood, takes_noise_for_no_second_side)
{
    // Half of the points are off, as far to the one side as to the other.
    constexpr double radius = 0.3;
    constexpr double height = 1 - 2.0 / 16;
    constexpr double noise = 2.5;
    const auto toBothSides = [](int i) { return i % 2 == 0 ? 0 : i % 4 == 1 ? noise : -noise; };
    const OutsideFlood flood(ball(cube, radius, centre), wall(radius, height, toBothSides), reach);
    EXPECT_FALSE(isOutside(flood, centre));
}

TEST(OutsideFlood, takes_back_a_blob_on_a_thin_sheet)
{
    // Half a ball on a sheet: its free surface is twice the disc that it stands on.
    const Grid blob = test::sampled(
        cube, [&](const Point3 &p) { return std::min(0.2 - (p - centre).Norm(), p.Z() - 0.5); });
    const OutsideFlood flood(blob, sheet(), reach);
    EXPECT_TRUE(isOutside(flood, centre + Point3(0, 0, 0.12)));
    // 0.113: a disc of radius 0.2 - 1.5 / 32 in a sheet of 0.8 × 0.8, whose crust has two sides and
    // rims besides.
    EXPECT_NEAR(flood.doubledShare(), 0.11, 0.03);
}

TEST(OutsideFlood, knows_a_sheet_by_what_would_be_doubled)
{
    const Grid above =
        test::sampled(cube, [](const Point3 &p) { return std::min(p.Z() - 0.5, 0.8 - p.Z()); });
    EXPECT_NEAR(OutsideFlood(above, sheet(), reach).doubledShare(), 0.94, 0.03); // 1 but for rims
}

} // namespace
} // namespace neuralmesh
