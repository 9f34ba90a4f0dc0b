// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_groups.h"

#include <gtest/gtest.h>

namespace neuralmesh {
namespace {

TEST(PointGroups, the_largest_is_that_of_most_points_in_reach_of_each_other)
{
    std::vector<Point3> points;
    for (int i = 0; i < 5; ++i) // a chain, whose ends are far from each other
        points.emplace_back(0.1 * i, 0, 0);
    for (int i = 0; i < 3; ++i) // a pile, apart
        points.emplace_back(2, 0.01 * i, 0);
    for (int i = 0; i < 9; ++i) // strays
        points.emplace_back(i, 5, 0);
    EXPECT_EQ(largestGroup(points, 0.101), 5U);
    EXPECT_EQ(largestGroup(points, 0.05), 3U);
    EXPECT_EQ(largestGroup(points, 10), points.size());
}

TEST(PointGroups, of_no_points_there_is_none)
{
    EXPECT_EQ(largestGroup({}, 1), 0U);
}

} // namespace
} // namespace neuralmesh
