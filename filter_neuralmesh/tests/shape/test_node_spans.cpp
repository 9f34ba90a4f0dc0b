// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/node_spans.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

/// Not a cube, so that no axis can stand for another.
constexpr GridSize cells{8, 12, 16};
const Grid grid(cells);

/// Cells away from the border: a few by chance, so that spans overlap, touch and lie apart.
std::vector<std::uint32_t> someCells(std::uint64_t seed, int count)
{
    Random random(seed);
    const auto below = [&](int n) {
        return 1 + static_cast<int>(random.below(static_cast<std::size_t>(n) - 2));
    };
    std::vector<std::uint32_t> chosen;
    for (int i = 0; i < count; ++i)
        chosen.push_back(
            static_cast<std::uint32_t>(grid.index(below(cells.x), below(cells.y), below(cells.z))));
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

/// The spans' nodes are the inner ones of a grid of this size for which isIn(x, y, z) says so.
template <class IsIn>
void expectNodes(const NodeSpans &nodes, const GridSize &size, const IsIn &isIn)
{
    const Grid places(size);
    const std::vector<unsigned char> found = test::marked(nodes, size);
    std::size_t count = 0;
    test::forEachNode(places, [&](int x, int y, int z) {
        const bool isExpected = test::isInner(places, x, y, z) && isIn(x, y, z);
        count += isExpected ? 1 : 0;
        EXPECT_EQ(found[places.index(x, y, z)], isExpected ? 1 : 0) << x << ' ' << y << ' ' << z;
    });
    EXPECT_EQ(nodes.size(), count);
}

TEST(NodeSpans, of_a_grid_are_all_inner_nodes)
{
    expectNodes(NodeSpans(cells), cells, [](int, int, int) { return true; });
}

TEST(NodeSpans, around_cells_reach_as_far_as_told_from_their_corners)
{
    for (const int distance : {0, 1, 3}) {
        const std::vector<std::uint32_t> chosen = someCells(1, 6);
        const auto isNear = [&](int node, std::ptrdiff_t cell) {
            return cell - distance <= node && node <= cell + 1 + distance;
        };
        expectNodes(NodeSpans(cells, chosen, distance), cells, [&](int x, int y, int z) {
            return std::any_of(chosen.begin(), chosen.end(), [&](std::uint32_t i) {
                const auto cell = static_cast<std::ptrdiff_t>(i);
                return isNear(x, cell / grid.strideX()) &&
                       isNear(y, cell % grid.strideX() / grid.strideY()) &&
                       isNear(z, cell % grid.strideY());
            });
        });
    }
}

TEST(NodeSpans, in_a_row_ascend_and_do_not_touch)
{
    const NodeSpans nodes(cells, someCells(2, 12), 0);
    int spans = 0;
    for (int x = 0; x <= cells.x; ++x)
        for (int y = 0; y <= cells.y; ++y) {
            int before = 0;
            nodes.forEachInRow(x, y, [&](int low, int end) {
                EXPECT_GT(low, before);
                EXPECT_GT(end, low);
                before = end;
                ++spans;
            });
        }
    EXPECT_GT(spans, 20);
}

TEST(NodeSpans, widened_take_in_the_nodes_beside_them)
{
    const NodeSpans nodes(cells, someCells(3, 4), 1);
    const std::vector<unsigned char> isIn = test::marked(nodes, cells);
    const std::ptrdiff_t sx = grid.strideX();
    const std::ptrdiff_t sy = grid.strideY();
    expectNodes(nodes.widened(), cells, [&](int x, int y, int z) {
        const unsigned char *here = isIn.data() + grid.index(x, y, z);
        return (here[0] | here[-1] | here[1] | here[-sy] | here[sy] | here[-sx] | here[sx]) != 0;
    });
}

TEST(NodeSpans, and_their_complement_are_all_inner_nodes)
{
    const NodeSpans nodes(cells, someCells(6, 6), 1);
    const std::vector<unsigned char> isIn = test::marked(nodes, cells);
    expectNodes(nodes.complement(), cells,
                [&](int x, int y, int z) { return isIn[grid.index(x, y, z)] == 0; });
}

TEST(NodeSpans, halved_are_all_coarse_nodes_that_restriction_reaches)
{
    const NodeSpans nodes(cells, someCells(4, 3), 1);
    const std::vector<unsigned char> isIn = test::marked(nodes, cells);
    const GridSize half{cells.x / 2, cells.y / 2, cells.z / 2};
    expectNodes(nodes.halved(), half, [&](int x, int y, int z) {
        for (int i = 2 * x - 1; i <= 2 * x + 1; ++i)
            for (int j = 2 * y - 1; j <= 2 * y + 1; ++j)
                for (int k = 2 * z - 1; k <= 2 * z + 1; ++k)
                    if (isIn[grid.index(i, j, k)] != 0)
                        return true;
        return false;
    });
}

TEST(NodeSpans, are_visited_once_each_with_several_threads)
{
    Workers workers(3);
    const NodeSpans nodes(cells, someCells(5, 20), 2);
    std::vector<unsigned char> visits(grid.size(), 0);
    nodes.forEach(workers, [&](int x, int y, int low, int end) {
        for (int z = low; z < end; ++z)
            ++visits[grid.index(x, y, z)];
    });
    EXPECT_EQ(visits, test::marked(nodes, cells));
}

} // namespace
} // namespace neuralmesh
