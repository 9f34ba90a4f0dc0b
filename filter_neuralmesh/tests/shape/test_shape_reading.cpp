// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/shape_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

constexpr int fewestVotes = 3;
constexpr double far = 2;

/// On the level set of the field, some to a cell.
test::Points pointsAt(const Grid &inside, float level = 0)
{
    return marchTetrahedra(inside, level, cellsBetween(inside, level, level)).points;
}

/// Times 4, so that the levels of ±0.1 lie within a cell of that at 0.
Grid ball(const Point3 &centre, double radius)
{
    return test::sampled(test::cube(32), [&](const Point3 &p) {
        return std::min(1.0, 4 * (radius - (p - centre).Norm()));
    });
}

Grid larger(Grid a, const Grid &b)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = std::max(a[i], b[i]);
    return a;
}

TEST(ShapeReading, all_levels_agree_on_a_torus_in_a_flat_box)
{
    const Grid torus = test::sampled({32, 32, 16}, [](const Point3 &p) {
        const Point3 q = p - Point3(0.5, 0.5, 0.25);
        return 4 * (0.12 - std::hypot(std::hypot(q.X(), q.Y()) - 0.3, q.Z()));
    });
    const ShapeReading reading = readShape(alone, torus, pointsAt(torus), far);
    EXPECT_EQ(reading.votes, ShapeReading::levelCount);
    EXPECT_EQ(reading.surface(fewestVotes).components, 1);
    EXPECT_EQ(reading.surface(fewestVotes).genus, 1);
    EXPECT_EQ(reading.surface(fewestVotes).missedShare, 0);
    // Of the level of the points, the first that has the shape.
    EXPECT_EQ(reading.surface(fewestVotes).soup.points, pointsAt(torus));
}

TEST(ShapeReading, takes_the_shape_of_most_levels_not_that_at_the_points)
{
    // A ring with a gap, in which the field is just above 0, and a hole, in which it is just below:
    // a handle at level 0, but none at the higher ones, where the gap is open, nor at the lower
    // ones, where the hole is filled.
    const Grid ring = test::sampled({32, 32, 16}, [](const Point3 &p) {
        const Point3 q = p - Point3(0.5, 0.5, 0.25);
        const double r = std::hypot(q.X(), q.Y());
        if (r > 0.4 || std::abs(q.Z()) > 0.1)
            return -1.0;
        if (r < 0.2)
            return -0.025;
        return q.X() > 0 && std::abs(q.Y()) < 0.08 ? 0.025 : 1.0;
    });
    const ShapeReading reading = readShape(alone, ring, pointsAt(ring, 0.1F), far);
    EXPECT_EQ(reading.votes, ShapeReading::levelCount - 1);
    EXPECT_EQ(reading.surface(fewestVotes).components, 1);
    EXPECT_EQ(reading.surface(fewestVotes).genus, 0);
}

TEST(ShapeReading, takes_the_simplest_shape_where_hardly_any_levels_agree)
{
    // Five blocks in a row, with the field just below each level in one of the four gaps.
    const Grid blocks = test::sampled({80, 16, 16}, [](const Point3 &p) {
        constexpr double heights[] = {-0.075, -0.025, 0.025, 0.075};
        if (std::max(std::abs(p.Y() - 0.1), std::abs(p.Z() - 0.1)) > 0.05 || p.X() < 0.1 ||
            p.X() > 0.96)
            return -1.0;
        const int tenth = static_cast<int>(p.X() * 10); // odd ones are blocks
        return tenth % 2 == 1 ? 1.0 : heights[tenth / 2 - 1];
    });
    const ShapeReading reading = readShape(alone, blocks, pointsAt(blocks, 0.1F), far);
    EXPECT_EQ(reading.votes, 1);
    EXPECT_EQ(reading.surface(fewestVotes).components, 1);
    // Without a least number of votes, the first level's shape has as many as the others.
    EXPECT_EQ(reading.surface(1).components, 3);
}

/// Two plates beside each other, with a hole each, in which the field is this, and a gap between
/// them, in which it is that.
Grid plates(double hole, double gap)
{
    return test::sampled({64, 32, 16}, [=](const Point3 &p) {
        if (std::abs(p.Z() - 0.12) > 0.05 || std::abs(p.Y() - 0.25) > 0.2 ||
            std::abs(p.X() - 0.5) > 0.45)
            return -1.0;
        if (std::abs(p.X() - 0.5) < 0.04)
            return gap;
        return std::hypot(std::abs(p.X() - 0.5) - 0.25, p.Y() - 0.25) < 0.08 ? hole : 1.0;
    });
}

/// On the upper and lower sides of the plates, or on all of their surface.
test::Points pointsOn(const Grid &inside, bool allOver)
{
    test::Points points = pointsAt(inside, 0.1F);
    const auto isBeside = [](const Point3 &p) { return std::abs(p.Z() - 0.12) < 0.03; };
    if (!allOver)
        points.erase(std::remove_if(points.begin(), points.end(), isBeside), points.end());
    return points;
}

LevelSurface withoutTunnels(const Grid &inside, bool allOver = false)
{
    const test::Points points = pointsOn(inside, allOver);
    ShapeReading reading = readShape(alone, inside, points, far);
    closeTunnels(reading, alone, inside, points, far);
    return reading.surfaces[reading.simplest];
}

TEST(ShapeReading, closes_tunnels_that_lower_levels_do_not_have)
{
    const Grid torn = plates(-0.18, -1);
    EXPECT_EQ(readShape(alone, torn, pointsOn(torn, false), far).surface(fewestVotes).genus, 2);
    EXPECT_EQ(withoutTunnels(torn).genus, 0);
    EXPECT_EQ(withoutTunnels(torn).components, 2);
    // A hole is as low as all that is outside.
    EXPECT_EQ(withoutTunnels(plates(-0.25, -1)).genus, 2);
    // A hole has points on its wall.
    EXPECT_EQ(withoutTunnels(torn, true).genus, 2);
    // What would join parts is no simpler.
    EXPECT_EQ(withoutTunnels(plates(-0.18, -0.14)).components, 2);
}

TEST(ShapeReading, leaves_out_parts_that_hold_hardly_any_points)
{
    const Grid first = ball({0.3, 0.5, 0.5}, 0.15);
    const Grid second = ball({0.75, 0.5, 0.5}, 0.1);
    const Grid both = larger(first, second);
    test::Points points = pointsAt(first);
    const test::Points others = pointsAt(second);
    points.insert(points.end(), others.begin(),
                  others.begin() + static_cast<std::ptrdiff_t>(ShapeReading::leastPoints) - 1);
    const ShapeReading one = readShape(alone, both, points, far);
    EXPECT_EQ(one.votes, ShapeReading::levelCount);
    EXPECT_EQ(one.surface(fewestVotes).components, 1);
    for (const Corners &face : one.surface(fewestVotes).soup.faces)
        EXPECT_LT(one.surface(fewestVotes).soup.points[face[0]].X(), 0.5);

    points.push_back(others.back());
    EXPECT_EQ(readShape(alone, both, points, far).surface(fewestVotes).components, 2);
}

TEST(ShapeReading, counts_the_points_that_are_far_from_the_surface)
{
    const Grid one = ball({0.5, 0.5, 0.5}, 0.2);
    test::Points points = pointsAt(one);
    const std::size_t near = points.size();
    // Cells of the surface reach up to a radius of 0.2 + √3 / 32: two cells further, no point is
    // near; one cell beyond the sphere, all are.
    for (const Point3 &p : pointsAt(ball({0.5, 0.5, 0.5}, 0.2 + 1.0 / 32)))
        points.push_back(p);
    EXPECT_EQ(readShape(alone, one, points, far).surface(fewestVotes).missedShare, 0);
    points.resize(near);
    for (std::size_t i = 0; i < near; ++i)
        points.emplace_back(0.5, 0.5, 0.5);
    EXPECT_EQ(readShape(alone, one, points, far).surface(fewestVotes).missedShare, 0.5);
}

TEST(ShapeReading, tells_the_share_of_the_points_further_than_a_cell)
{
    // A distance is its own first-order approximation.
    const Grid one = test::sampled(test::cube(32), [](const Point3 &p) {
        return std::clamp(0.3 - (p - Point3(0.5, 0.5, 0.5)).Norm(), -1.0, 1.0);
    });
    test::Points points;
    for (const double cells : {0.0, 0.9, -0.9, 1.1, -1.1})
        points.emplace_back(0.5, 0.5, 0.8 + cells / 32);
    EXPECT_DOUBLE_EQ(readShape(alone, one, points, far).unexplainedShare, 0.4);
}

TEST(ShapeReading, of_a_grid_that_explains_hardly_more_is_of_noise)
{
    const auto isNoise = [](double finer, int votesOfFiner, double coarser, int votesOfCoarser) {
        ShapeReading f;
        f.unexplainedShare = finer;
        f.votes = votesOfFiner;
        ShapeReading c;
        c.unexplainedShare = coarser;
        c.votes = votesOfCoarser;
        return isOfNoise(f, c);
    };
    EXPECT_TRUE(isNoise(0.5, 5, 0.4, 5));
    EXPECT_TRUE(isNoise(0.42, 5, 0.44, 5));
    EXPECT_FALSE(isNoise(0.35, 5, 0.44, 5));
    EXPECT_FALSE(isNoise(0.3, 5, 0.1, 5));
    // Fewer are enough where the finer grid's levels disagree, and those of the coarser one do not.
    EXPECT_TRUE(isNoise(0.15, 2, 0.1, 4));
    EXPECT_FALSE(isNoise(0.15, 2, 0.1, 3));
    EXPECT_FALSE(isNoise(0.15, 3, 0.1, 4));
    EXPECT_FALSE(isNoise(0.05, 2, 0.01, 4));
}

TEST(ShapeReading, of_a_field_without_an_inside_has_no_parts)
{
    const Grid nowhere(test::cube(8), -1);
    const ShapeReading reading = readShape(alone, nowhere, {{0.5, 0.5, 0.5}}, far);
    EXPECT_EQ(reading.surface(fewestVotes).components, 0);
    EXPECT_TRUE(reading.surface(fewestVotes).soup.faces.empty());
    EXPECT_EQ(reading.surface(fewestVotes).missedShare, 1);
}

} // namespace
} // namespace neuralmesh
