// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/grid_filters.h"

#include <gtest/gtest.h>

#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

/// Not a cube, so that no axis can stand for another.
constexpr GridSize cells{8, 12, 16};

double sum(const Grid &grid)
{
    return test::dot(grid, Grid(grid.cells(), 1));
}

double linear(const Point3 &p)
{
    return 1 + 2 * p.X() - 3 * p.Y() + 5 * p.Z();
}

TEST(GridFilters, smooth_turns_an_impulse_into_the_binomial_kernel)
{
    Grid grid(cells);
    grid.at(4, 5, 6) = 4096;
    smooth(alone, grid, innerNodes(grid), 2);
    const auto kernel = [](int offset) { // in sixteenths
        constexpr float row[] = {6, 4, 1};
        return std::abs(offset) > 2 ? 0 : row[std::abs(offset)];
    };
    test::forEachNode(grid, [&](int x, int y, int z) {
        EXPECT_EQ(grid.at(x, y, z), kernel(x - 4) * kernel(y - 5) * kernel(z - 6))
            << x << ' ' << y << ' ' << z;
    });
}

TEST(GridFilters, smooth_keeps_sums_and_linear_functions_away_from_the_border)
{
    Grid inner = test::noise(cells, 1, 3);
    const double before = sum(inner);
    smooth(alone, inner, innerNodes(inner), 2);
    EXPECT_NEAR(sum(inner), before, 1e-4); // rounding of a thousand values in single precision

    Grid plane = test::sampled(cells, linear);
    const Grid expected = plane;
    smooth(alone, plane, innerNodes(plane), 1);
    test::forEachNode(plane, [&](int x, int y, int z) {
        EXPECT_NEAR(plane.at(x, y, z), expected.at(x, y, z), 1e-5) << x << ' ' << y << ' ' << z;
    });
}

TEST(GridFilters, smooth_in_a_box_is_the_same_where_nothing_is_nearer_to_its_border_than_the_kernel)
{
    Grid everywhere = test::noise(cells, 2, 4);
    Grid inBox = everywhere;
    smooth(alone, everywhere, innerNodes(everywhere), 2);
    smooth(alone, inBox, {{2, 2, 2}, {6, 10, 14}}, 2);
    for (std::size_t i = 0; i < inBox.size(); ++i)
        EXPECT_EQ(inBox[i], everywhere[i]) << i;
}

TEST(GridFilters, smooth_changes_nothing_around_its_box)
{
    const Grid before = test::noise(cells, 2);
    Grid after = before;
    smooth(alone, after, {{2, 3, 4}, {5, 7, 11}}, 2);
    test::forEachNode(before, [&](int x, int y, int z) {
        const bool isIn = 2 <= x && x <= 5 && 3 <= y && y <= 7 && 4 <= z && z <= 11;
        const bool isChanged = after.at(x, y, z) != before.at(x, y, z);
        EXPECT_EQ(isChanged, isIn) << x << ' ' << y << ' ' << z;
    });
}

TEST(GridFilters, doubled_reproduces_linear_functions)
{
    const Grid fine = doubled(test::sampled(cells, linear));
    const Grid expected = test::sampled(cells.doubled(), linear);
    ASSERT_EQ(fine.size(), expected.size());
    for (std::size_t i = 0; i < fine.size(); ++i)
        EXPECT_NEAR(fine[i], expected[i], 1e-5) << i;
}

TEST(GridFilters, doubled_keeps_the_coarse_nodes)
{
    const Grid coarse = test::noise(cells, 2);
    const Grid fine = doubled(coarse);
    test::forEachNode(coarse, [&](int x, int y, int z) {
        EXPECT_EQ(fine.at(2 * x, 2 * y, 2 * z), coarse.at(x, y, z));
    });
}

TEST(GridFilters, halved_sums_keep_the_total_and_the_place)
{
    const Grid fine = test::noise(cells, 3);
    const Grid coarse = halvedSums(fine);
    EXPECT_EQ(coarse.cells().x, cells.x / 2);
    EXPECT_EQ(coarse.cells().y, cells.y / 2);
    EXPECT_EQ(coarse.cells().z, cells.z / 2);
    EXPECT_NEAR(sum(coarse), sum(fine), 1e-4); // rounding of two thousand values

    Grid impulse(cells);
    impulse.at(4, 3, 7) = 1;
    // Nodes 2x - 1 and 2x go to node x.
    EXPECT_EQ(halvedSums(impulse).at(2, 2, 4), 1);
}

} // namespace
} // namespace neuralmesh
