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

/// So many passes have a kernel that is wide for a coarser grid, too, and narrow for this one.
constexpr GridSize fineCells{32, 40, 48};
constexpr int manyPasses = 62;

TEST(GridFilters, many_passes_of_smooth_are_done_on_a_coarser_grid)
{
    Grid grid = test::noise(fineCells, 3);
    smooth(alone, grid, NodeSpans(fineCells), manyPasses);
    // Interpolated. The kernel on the grid itself is curved.
    for (int y = 3; y < fineCells.y - 2; y += 2)
        EXPECT_FLOAT_EQ(grid.at(16, y, 24), (grid.at(16, y - 1, 24) + grid.at(16, y + 1, 24)) / 2)
            << y;
}

TEST(GridFilters, many_passes_of_smooth_have_the_kernel_of_as_many)
{
    Grid atOnce(fineCells);
    atOnce.at(15, 21, 24) = 1;
    Grid inParts = atOnce;
    smooth(alone, atOnce, NodeSpans(fineCells), manyPasses);
    for (const int few : {31, 31})
        smooth(alone, inParts, NodeSpans(fineCells), few);
    // Interpolation along an axis takes 1/8 of the curvature from the peak: of a kernel whose
    // variance is 62 / 2 / 4 coarse cells, 0.016.
    const float peak = inParts.at(15, 21, 24);
    for (std::size_t i = 0; i < atOnce.size(); ++i)
        EXPECT_NEAR(atOnce[i] / peak, inParts[i] / peak, 3 * 0.0165) << i;
    EXPECT_NEAR(sum(atOnce) / sum(inParts), 1, 0.01); // the border takes some of both
}

TEST(GridFilters, many_passes_of_smooth_are_their_own_adjoint)
{
    const Grid a = test::noise(fineCells, 3);
    const Grid b = test::noise(fineCells, 4);
    Grid smoothA = a;
    Grid smoothB = b;
    smooth(alone, smoothA, NodeSpans(fineCells), manyPasses);
    smooth(alone, smoothB, NodeSpans(fineCells), manyPasses);
    const double along = test::dot(smoothA, b);
    EXPECT_NEAR(test::dot(a, smoothB), along, 1e-4 * std::abs(along));
}

TEST(GridFilters, many_passes_of_smooth_change_nothing_but_their_nodes)
{
    const Grid grid(fineCells);
    const NodeSpans nodes(fineCells, {static_cast<std::uint32_t>(grid.index(9, 20, 31))}, 5);
    const std::vector<unsigned char> isIn = test::marked(nodes, fineCells);
    const Grid before = test::noise(fineCells, 2);
    Grid after = before;
    smooth(alone, after, nodes, manyPasses);
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
