// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/spacing_spread.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

SpacingSpread spreadOf(const test::WorldPoints &points)
{
    PointTree tree(points);
    return spacingSpread(points, tree);
}

void addSquare(test::WorldPoints &points, int count, double x)
{
    Random random(1);
    for (int i = 0; i < count; ++i)
        points.emplace_back(x + random.unit(), random.unit(), 0);
}

TEST(SpacingSpread, a_uniform_sample_is_even_whatever_its_size)
{
    for (const int count : {20, 500, 20000}) {
        test::WorldPoints points;
        addSquare(points, count, 0);
        EXPECT_FALSE(spreadOf(points).isUneven()) << count;
    }
}

TEST(SpacingSpread, half_of_a_surface_is_a_sparse_end_however_few_its_points)
{
    for (const int ratio : {10, 40}) {
        test::WorldPoints points;
        addSquare(points, 20000, 0);
        addSquare(points, 20000 / ratio, 1);
        const SpacingSpread spread = spreadOf(points);
        EXPECT_TRUE(spread.isUneven());
        EXPECT_NEAR(spread.sparse / spread.dense / std::sqrt(ratio), 1.4, 0.3);
    }
}

TEST(SpacingSpread, the_last_few_points_of_heavy_tails_are_no_sparse_end)
{
    // Cauchy-distributed: the last ten in a thousand stand for nearly all of the surface.
    Random random(3);
    const auto cauchy = [&] { return std::tan(M_PI * (random.unit() - 0.5)); };
    test::WorldPoints points;
    for (int i = 0; i < 1000; ++i)
        points.emplace_back(cauchy(), cauchy(), cauchy());
    PointTree tree(points);
    const double sparse = spacingSpread(points, tree).sparse;
    int beyond = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        beyond += tree.usualDistance(i, neighbourOfSpacing) > sparse ? 1 : 0;
    EXPECT_GE(beyond, 9);
}

TEST(PointTree, has_the_same_usual_distances_one_by_one_and_of_all)
{
    test::WorldPoints points;
    addSquare(points, 500, 0);
    PointTree tree(points);
    const std::vector<double> all = tree.usualDistances(neighbourOfSpacing);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(tree.usualDistance(i, neighbourOfSpacing), all[i]) << i;
}

TEST(SpacingSpread, strays_are_no_sparse_end)
{
    test::WorldPoints points;
    addSquare(points, 10000, 0);
    Random random(2);
    for (int i = 0; i < 500; ++i)
        points.emplace_back(random.unit(), random.unit(), 0.1 * random.unit() - 0.05);
    EXPECT_FALSE(spreadOf(points).isUneven());
}

} // namespace
} // namespace neuralmesh
