// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/attribute_transfer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace neuralmesh {
namespace {

/// Corners on the axes: each is joined to all but the one opposite, at the next or previous place.
const Mesh octahedron{
    {{{1, 0, 0}}, {{-1, 0, 0}}, {{0, 1, 0}}, {{0, -1, 0}}, {{0, 0, 1}}, {{0, 0, -1}}},
    {{{0, 2, 4}},
     {{2, 1, 4}},
     {{1, 3, 4}},
     {{3, 0, 4}},
     {{2, 0, 5}},
     {{1, 2, 5}},
     {{3, 1, 5}},
     {{0, 3, 5}}}};

TEST(AttributeTransfer, a_vertex_has_the_mean_of_its_points)
{
    AttributeTransfer transfer(octahedron);
    // Symmetric about vertex 0, so that both count the same.
    transfer.add({1, 0.1, 0}, {10, 0, 0, 255, 1});
    transfer.add({1, -0.1, 0}, {30, 0, 0, 255, 3});
    EXPECT_EQ(transfer.average()[0], (AttributeValues{20, 0, 0, 255, 2}));
}

TEST(AttributeTransfer, vertices_without_points_take_what_their_neighbours_have)
{
    AttributeTransfer transfer(octahedron);
    transfer.add({1, 0, 0}, {8, 0, 0, 255, 0.5});
    for (const AttributeValues &values : transfer.average()) // vertex 1 is two edges away
        EXPECT_EQ(values, (AttributeValues{8, 0, 0, 255, 0.5}));
}

TEST(AttributeTransfer, looks_at_points_all_over_where_time_is_up)
{
    // Of each half, one colour: a prefix would leave the second out.
    std::vector<Point> points(500000, Point{1, 0, 0});
    std::vector<AttributeValues> values(points.size(), AttributeValues{0, 0, 0, 255, 0});
    std::fill(values.begin() + 250000, values.end(), AttributeValues{200, 0, 0, 255, 0});
    int reports = 0;
    const Progress late([&](double, const char *) { return ++reports > 0; }, [] { return true; });
    AttributeTransfer transfer(octahedron);
    transfer.addPoints(points, values, 1, late);
    EXPECT_NEAR(transfer.average()[0][0], 100, 1);
    EXPECT_LT(reports, 15); // of 123 for all points
}

TEST(AttributeTransfer, is_cancelled_where_progress_says_so)
{
    const Progress stop([](double, const char *) { return false; });
    AttributeTransfer transfer(octahedron);
    EXPECT_THROW(transfer.addPoints({{1, 0, 0}}, {{}}, 1, stop), Cancelled);
    EXPECT_THROW(transfer.addSurface(octahedron, std::vector<AttributeValues>(6), 10, stop),
                 Cancelled);
}

TEST(AttributeTransfer, a_point_far_off_colours_next_to_nothing)
{
    AttributeTransfer transfer(octahedron);
    for (int i = 0; i < 10; ++i)
        transfer.add({1, 0, 0}, {100, 0, 0, 255, 0});
    transfer.add({20, 0, 0}, {0, 0, 0, 255, 0}); // 13 edges away: its weight is 1 / 32,000
    EXPECT_NEAR(transfer.average()[0][0], 100, 0.01);
}

TEST(AttributeTransfer, values_come_in_order_of_the_vertices)
{
    AttributeTransfer transfer(octahedron);
    for (std::size_t v = 0; v < 6; ++v)
        transfer.add(octahedron.positions[v], {0, 0, 0, 255, static_cast<double>(v)});
    const std::vector<AttributeValues> found = transfer.average();
    ASSERT_EQ(found.size(), 6U);
    for (std::size_t v = 0; v < 6; ++v)
        EXPECT_EQ(found[v][4], static_cast<double>(v));
}

TEST(AttributeTransfer, places_on_a_surface_have_values_between_those_of_its_corners)
{
    std::vector<AttributeValues> heights;
    for (const Point &p : octahedron.positions)
        heights.push_back({0, 0, 0, 255, p[2]});
    AttributeTransfer transfer(octahedron);
    transfer.addSurface(octahedron, heights, 6000);
    const std::vector<AttributeValues> found = transfer.average();
    // Nearest to the upper corner are the places where its weight, which is the height, is the
    // largest of three: 11/18 in the mean. Five standard deviations of 1,000 of them: 0.03.
    EXPECT_NEAR(found[4][4], 11.0 / 18, 0.03);
    EXPECT_NEAR(found[5][4], -11.0 / 18, 0.03);
    // As much above as below the others: at most 0.5, with a deviation of 0.2.
    EXPECT_NEAR(found[0][4], 0, 0.03);
}

} // namespace
} // namespace neuralmesh
