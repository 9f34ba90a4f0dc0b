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
    smooth(alone, grid, NodeSpans(cells), 2);
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
    smooth(alone, inner, NodeSpans(cells), 2);
    EXPECT_NEAR(sum(inner), before, 1e-4); // rounding of a thousand values in single precision

    Grid plane = test::sampled(cells, linear);
    const Grid expected = plane;
    smooth(alone, plane, NodeSpans(cells), 1);
    test::forEachNode(plane, [&](int x, int y, int z) {
        if (test::isInner(plane, x, y, z, 2)) {
            EXPECT_NEAR(plane.at(x, y, z), expected.at(x, y, z), 1e-5) << x << ' ' << y << ' ' << z;
        }
    });
}

/// Two cells that have rows in common, each by its lowest node.
std::vector<std::uint32_t> twoCells()
{
    const Grid grid(cells);
    return {static_cast<std::uint32_t>(grid.index(3, 5, 4)),
            static_cast<std::uint32_t>(grid.index(4, 5, 10))};
}

TEST(GridFilters, smooth_around_cells_is_the_same_where_these_hold_all_that_the_kernel_reaches)
{
    Grid everywhere(cells);
    for (const std::uint32_t cell : twoCells())
        everywhere[cell] = 1;
    Grid around = everywhere;
    smooth(alone, everywhere, NodeSpans(cells), 2);
    smooth(alone, around, NodeSpans(cells, twoCells(), 2), 2);
    for (std::size_t i = 0; i < around.size(); ++i)
        EXPECT_EQ(around[i], everywhere[i]) << i;
}

TEST(GridFilters, smooth_changes_nothing_but_its_nodes)
{
    const NodeSpans nodes(cells, twoCells(), 1);
    const std::vector<unsigned char> isIn = test::marked(nodes, cells);
    const Grid before = test::noise(cells, 2);
    Grid after = before;
    smooth(alone, after, nodes, 2);
    for (std::size_t i = 0; i < after.size(); ++i)
        EXPECT_EQ(after[i] != before[i], isIn[i] != 0) << i;
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

TEST(GridFilters, halved_sums_of_nodes_are_those_of_a_grid_that_is_0_elsewhere)
{
    const NodeSpans nodes(cells, twoCells(), 2);
    const std::vector<unsigned char> isIn = test::marked(nodes, cells);
    Grid fine = test::noise(cells, 3);
    for (std::size_t i = 0; i < fine.size(); ++i)
        fine[i] *= isIn[i];
    const Grid expected = halvedSums(fine);
    const Grid coarse = halvedSums(fine, nodes);
    for (std::size_t i = 0; i < coarse.size(); ++i)
        EXPECT_EQ(coarse[i], expected[i]) << i;
}

} // namespace
} // namespace neuralmesh
