// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs meeting(const BoxTree &tree)
{
    Pairs found;
    for (std::size_t leaf = 0; leaf < tree.leafCount(); ++leaf)
        tree.forEachPair(leaf, [&](std::uint32_t i, std::uint32_t j) {
            found.emplace_back(std::min(i, j), std::max(i, j));
        });
    std::sort(found.begin(), found.end());
    return found;
}

/// Boxes of sizes that differ by a thousand, most of which crowd around the origin.
std::vector<Box3> crowdedBoxes(std::size_t count)
{
    Random random(4);
    std::vector<Box3> boxes;
    while (boxes.size() < count) {
        const Scalar size = std::pow(10, -3 * random.unit());
        const Point3 corner = test::inUnitCube(random) * std::pow(random.unit(), 8);
        boxes.emplace_back(corner, corner + test::inUnitCube(random) * size);
    }
    return boxes;
}

TEST(BoxTree, finds_all_pairs_of_boxes_that_meet_each_once)
{
    for (const std::size_t count :
         {std::size_t(1), std::size_t(8), std::size_t(9), std::size_t(700)}) {
        const std::vector<Box3> boxes = crowdedBoxes(count);
        Pairs expected;
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t j = i + 1; j < count; ++j)
                if (boxes[i].Collide(boxes[j]))
                    expected.emplace_back(i, j);
        EXPECT_EQ(meeting(BoxTree(boxes)), expected);
    }
}

/// The squared distance of the point that is nearest to a place, and how many were looked at.
std::pair<Scalar, int> nearest(const BoxTree &tree, const std::vector<Box3> &points,
                               const Point3 &place)
{
    Scalar least = std::numeric_limits<Scalar>::infinity();
    int visited = 0;
    tree.forEachNear(place, least, [&](std::uint32_t i) {
        least = std::min(least, (points[i].min - place).SquaredNorm());
        ++visited;
    });
    return {least, visited};
}

TEST(BoxTree, finds_the_nearest_point_among_few)
{
    Random random(5);
    std::vector<Box3> points;
    for (int i = 0; i < 4000; ++i) {
        const Point3 place = test::inUnitCube(random) * std::pow(random.unit(), 8);
        points.emplace_back(place, place);
    }
    const BoxTree tree(points);
    double sum = 0;
    for (const Box3 &at : points) {
        const Point3 place = at.min + test::inUnitCube(random) * 0.01;
        Scalar expected = std::numeric_limits<Scalar>::infinity();
        for (const Box3 &point : points)
            expected = std::min(expected, (point.min - place).SquaredNorm());
        const auto [least, visited] = nearest(tree, points, place);
        EXPECT_EQ(least, expected);
        sum += visited;
    }
    EXPECT_LT(sum / static_cast<double>(points.size()), 60);
    EXPECT_EQ(nearest(BoxTree({}), {}, {0, 0, 0}).second, 0);
}

TEST(BoxTree, finds_boxes_without_a_width_and_nothing_where_there_are_none)
{
    const Box3 flat({0, 0, 0}, {1, 1, 0});
    const Box3 beside({1, 0, 0}, {2, 1, 0});
    EXPECT_EQ(meeting(BoxTree({flat, flat, beside})).size(), 3U);
    EXPECT_TRUE(meeting(BoxTree({})).empty());
}

} // namespace
} // namespace neuralmesh
