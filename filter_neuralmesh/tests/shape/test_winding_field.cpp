// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/winding_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/points_for_tests.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

constexpr int resolution = 32;
const GridSize cube = test::cube(resolution);
const Point3 centre(0.5, 0.5, 0.5);

void learn(WindingField &field, int rounds, int smoothings)
{
    for (int round = 0; round < rounds; ++round)
        field.improve(smoothings + (2 - smoothings) * round / (rounds - 1));
}

/// With the rounds and kernels that findCoarseShape() gives its first grid.
WindingField learned(const test::Points &points, const GridSize &cells = cube)
{
    WindingField field(points, cells, alone);
    learn(field, 20, 8);
    return field;
}

double at(const Grid &grid, const Point3 &place)
{
    return static_cast<double>(interpolate(grid, placeInGrid(grid, place)));
}

test::Points sphere(double radius, std::size_t count, const Point3 &middle = centre)
{
    const test::WorldPoints points = test::spherePoints(count, 1);
    return test::moved({points.begin(), points.end()}, radius, middle);
}

double rms(const WindingField &field, const test::Points &points)
{
    double squared = 0;
    for (const Point3 &p : points)
        squared += std::pow(at(field.field(), p) - 0.5, 2);
    return std::sqrt(squared / static_cast<double>(points.size()));
}

/// Three cells away from the surface: nearer, the kernels of the sources round the step off.
void expectSides(const WindingField &field, const Point3 &middle, double radius)
{
    Random random(2);
    double leastInside = 1;
    double mostInside = 1;
    double mostOutside = 0;
    for (int i = 0; i < 1000; ++i) {
        Point3 place;
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = random.unit() * 2 * middle[axis];
        const double distance = ((place - middle).Norm() - radius) * resolution;
        const double value = at(field.field(), place);
        if (distance > 3)
            mostOutside = std::max(mostOutside, std::abs(value));
        if (distance < -3) {
            leastInside = std::min(leastInside, value);
            mostInside = std::max(mostInside, value);
        }
    }
    // 0.07, 1.02 and 1.19: on the inner side of a sphere the kernels are crowded.
    EXPECT_LT(mostOutside, 0.1);
    EXPECT_GT(leastInside, 0.95);
    EXPECT_LT(mostInside, 1.25);
}

TEST(WindingField, is_1_inside_a_sphere_and_0_outside)
{
    expectSides(learned(sphere(0.3, 3000)), centre, 0.3);
}

TEST(WindingField, is_the_same_in_a_box_that_is_no_cube)
{
    const Point3 middle(0.5, 0.375, 0.4375);
    expectSides(learned(sphere(0.25, 3000, middle), {32, 24, 28}), middle, 0.25);
}

TEST(WindingField, is_a_half_at_the_points)
{
    const test::Points points = sphere(0.3, 3000);
    EXPECT_LT(rms(learned(points), points), 0.01); // 0.005, after 0.06 in the first round
}

TEST(WindingField, settles_and_does_not_swing_from_round_to_round)
{
    const test::Points points = sphere(0.3, 3000);
    WindingField field = learned(points);
    double sum = 0;
    for (int i = 0; i < 10; ++i) {
        const Grid before = field.field();
        field.improve(2);
        double squared = 0;
        for (const Point3 &p : points)
            squared += std::pow(at(field.field(), p) - at(before, p), 2);
        sum += std::sqrt(squared / static_cast<double>(points.size()));
    }
    // 0.024; 0.048 where the normals turn all the way to the gradient.
    EXPECT_LT(sum, 0.035);
}

TEST(WindingField, keeps_what_it_has_learned_on_a_finer_grid)
{
    const test::Points points = sphere(0.3, 6000); // of which the first grid takes every second
    WindingField field = learned(points);
    const double before = at(field.field(), centre);
    field.refine();
    EXPECT_EQ(field.field().resolution(), 2 * resolution);
    EXPECT_NEAR(at(field.field(), centre), before, 1e-5); // interpolated, but for rounding
    // The normals of the points that took part already, and of those that come in, make up the
    // same field on the finer grid: 1.08 after 1.11.
    field.improve(4);
    EXPECT_NEAR(at(field.field(), centre), before, 0.05);
    EXPECT_LT(rms(field, points), 0.01); // 0.004
}

TEST(WindingField, takes_one_side_of_a_sheet_throughout)
{
    // The points scatter over 1.3 cells, so that descent alone finds no side: without the common
    // lean, a quarter of them are on the other.
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        Random random(seed);
        test::Points points;
        for (int i = 0; i < 3000; ++i) {
            const double x = 0.2 + 0.6 * random.unit();
            const double y = 0.2 + 0.6 * random.unit();
            points.emplace_back(x, y, 0.48 + 0.04 * random.unit());
        }
        const WindingField field = learned(points);
        int rising = 0;
        const Point3 up(0, 0, 2.0 / resolution);
        for (const Point3 &p : points)
            rising += at(field.field(), p + up) > at(field.field(), p - up) ? 1 : 0;
        // Which side is chance.
        EXPECT_TRUE(rising == 0 || rising == static_cast<int>(points.size()))
            << rising << " of the points, seed " << seed;
    }
}

TEST(WindingField, holds_the_outside_at_0)
{
    const test::Points points = sphere(0.3, 3000);
    WindingField field(points, cube, alone);
    learn(field, 3, 8);
    // From a tenth of the unit cube beyond the sphere on.
    std::vector<unsigned char> outside(field.field().size(), 0);
    test::forEachNode(field.field(), [&](int x, int y, int z) {
        if ((Point3(x, y, z) / resolution - centre).Norm() > 0.4)
            outside[field.field().index(x, y, z)] = 1;
    });
    const auto largestOutside = [&] {
        float most = 0;
        for (std::size_t i = 0; i < outside.size(); ++i)
            if (outside[i] != 0)
                most = std::max(most, std::abs(field.field()[i]));
        return most;
    };
    EXPECT_GT(largestOutside(), 0.02F) << "There is nothing to hold.";
    field.holdOutside(outside);
    EXPECT_EQ(largestOutside(), 0);
    field.improve(8);
    EXPECT_EQ(largestOutside(), 0);
}

TEST(WindingField, is_smooth_beside_an_outside_that_ends_far_from_all_points)
{
    // A ball without its upper half, closed by a membrane, of which the outside takes the upper
    // part: where it ends, the field was as high as inside.
    test::Points points;
    for (const Point3 &p : sphere(0.3, 8000))
        if (p.Z() < 0.5)
            points.push_back(p);
    constexpr int cells = 64; // a grid that is worked on around the points alone
    constexpr int ceiling = 28;
    WindingField field(points, test::cube(cells), alone);
    learn(field, 6, 4);
    std::vector<unsigned char> outside(field.field().size(), 0);
    test::forEachNode(field.field(), [&](int x, int y, int z) {
        outside[field.field().index(x, y, z)] = z >= ceiling ? 1 : 0;
    });
    EXPECT_GT(at(field.field(), Point3(0.5, 0.5, 28.0 / cells)), 0.4) << "Nothing ends abruptly.";
    field.holdOutside(outside);
    learn(field, 3, 2);
    const Grid &u = field.field();
    double largest = 0;
    for (int x = 27; x <= 37; ++x)
        for (int y = 27; y <= 37; ++y)
            for (int z = 20; z < ceiling; ++z)
                largest = std::max(
                    largest, std::abs(static_cast<double>(u.at(x - 1, y, z) + u.at(x + 1, y, z) +
                                                          u.at(x, y - 1, z) + u.at(x, y + 1, z) +
                                                          u.at(x, y, z - 1) + u.at(x, y, z + 1) -
                                                          6 * u.at(x, y, z))));
    // 0.02; 0.95 where nothing is worked on around the end.
    EXPECT_LT(largest, 0.05);
}

TEST(WindingField, level_of_points_is_between_the_inside_and_the_outside_of_a_thin_rod)
{
    // A rod out of a ball, two cells thick: the field does not rise to 1/2 all along it.
    Random random(3);
    test::Points points = sphere(0.2, 6000);
    for (int i = 0; i < 2000; ++i) {
        const double a = 2 * M_PI * random.unit();
        const double x = 0.69 + 0.2 * random.unit();
        points.emplace_back(x, 0.5 + std::cos(a) / resolution, 0.5 + std::sin(a) / resolution);
    }
    WindingField field = learned(points);
    const Grid level = field.levelOfPoints();
    double leastField = 1;
    double leastRise = 1;
    double leastFall = 1;
    for (double x = 0.72; x < 0.87; x += 0.01) {
        const Point3 place(x, 0.5, 0.5);
        const Point3 beside = place + Point3(0, 3.0 / resolution, 0);
        leastField = std::min(leastField, at(field.field(), place));
        leastRise = std::min(leastRise, at(field.field(), place) - at(level, place));
        leastFall = std::min(leastFall, at(level, beside) - at(field.field(), beside));
    }
    EXPECT_LT(leastField, 0.5) << "A level of 1/2 would do.";
    EXPECT_GT(leastRise, 0.02); // 0.033
    EXPECT_GT(leastFall, 0.2);  // 0.3
}

TEST(WindingField, level_of_points_is_a_half_where_no_points_are)
{
    WindingField field = learned(sphere(0.2, 1000));
    EXPECT_FLOAT_EQ(field.levelOfPoints().at(2, 2, 2), 0.5F);
}

TEST(WindingField, goes_back_to_where_it_was)
{
    const test::Points points = sphere(0.3, 2000);
    WindingField field(points, cube, alone);
    learn(field, 5, 8);
    const WindingField::State before = field.state();
    const double error = rms(field, points);
    field.improve(2);
    EXPECT_NE(rms(field, points), error);
    field.goBack(before);
    EXPECT_EQ(rms(field, points), error);
    field.improve(2);
    const double once = rms(field, points);
    field.goBack(before);
    field.improve(2);
    EXPECT_EQ(rms(field, points), once); // its normals, too
}

} // namespace
} // namespace neuralmesh
