// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/even_density.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/space/point_index.h"
#include "tests/points_for_tests.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

/// Of the unit square, `ratio` times as dense at x = 1 as at 0.
test::Points square(std::size_t count, double ratio)
{
    Random random(1);
    test::Points points;
    while (points.size() < count) {
        const Point3 p(random.unit(), random.unit(), 0);
        if (random.unit() < std::pow(ratio, p.X() - 1))
            points.push_back(p);
    }
    return points;
}

double countIn(const test::Points &points, double low, double high)
{
    double count = 0;
    for (const Point3 &p : points)
        count += p.X() >= low && p.X() < high ? 1 : 0;
    return count;
}

TEST(EvenDensity, leaves_a_uniform_sample_as_it_is)
{
    const test::Points points = square(10000, 1);
    EXPECT_EQ(withEvenDensity(points), points);
}

TEST(EvenDensity, thins_the_dense_end_to_the_sparse_one)
{
    const test::Points points = square(20000, 10);
    ASSERT_GT(countIn(points, 0.8, 1) / countIn(points, 0, 0.2), 5);
    const test::Points even = withEvenDensity(points);
    EXPECT_LT(even.size(), points.size() / 2);
    EXPECT_LT(countIn(even, 0.8, 1) / countIn(even, 0, 0.2), 2.5);
    // No point is far from one that stays.
    const PointIndex left(even);
    for (const Point3 &p : points)
        EXPECT_TRUE(left.hasWithin(p, 0.03));
}

TEST(EvenDensity, thins_a_half_that_has_nearly_all_points)
{
    test::Points points = square(20000, 1);
    points.erase(std::remove_if(points.begin(), points.end(),
                                [random = Random(2)](const Point3 &p) mutable {
                                    return p.X() < 0.5 && random.unit() > 0.05;
                                }),
                 points.end());
    ASSERT_GT(countIn(points, 0.5, 1) / countIn(points, 0, 0.5), 15);
    const test::Points even = withEvenDensity(points);
    EXPECT_LT(countIn(even, 0.5, 1) / countIn(even, 0, 0.5), 2.5);
}

TEST(EvenDensity, counts_repeated_points_once)
{
    test::Points points = square(5000, 1);
    const test::Points once = points;
    for (const Point3 &p : once)
        if (p.X() > 0.5)
            points.insert(points.end(), 9, p);
    EXPECT_EQ(withEvenDensity(points).size(), points.size());
}

TEST(EvenDensity, of_a_few_points_is_all_of_them)
{
    EXPECT_EQ(withEvenDensity({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 3U);
}

} // namespace
} // namespace neuralmesh
