// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/vertex_grid.h"

#include <gtest/gtest.h>

#include "tests/space/brute_force.h"

namespace neuralmesh {
namespace {

void churn(const Box3 &bounds, std::uint64_t seed, int operations)
{
    Random random(seed);
    VertexGrid grid(bounds);
    Positions positions;
    VertexId hint = noVertex;
    for (int i = 0; i < operations; ++i) {
        const Point3 p = randomPoint(random, bounds);
        const auto id = static_cast<VertexId>(random.below(300));
        const std::uint64_t choice = random.below(8);
        if (choice < 2 && !grid.contains(id)) {
            grid.insert(id, p);
            positions[id] = p;
        } else if (choice < 4 && grid.contains(id)) {
            grid.move(id, p);
            positions[id] = p;
        } else if (choice == 4 && grid.contains(id)) {
            grid.erase(id);
            positions.erase(id);
        } else {
            const VertexId expected = nearestByBruteForce(positions, p);
            ASSERT_EQ(grid.nearest(p), expected) << "operation " << i;
            ASSERT_EQ(grid.nearest(p, hint), expected) << "with a hint, operation " << i;
            hint = id;
            const Scalar radius = 0.3 * random.unit();
            const int within = countWithin(positions, p, radius);
            int visited = 0;
            grid.forEachWithin(p, radius, [&](VertexId) { ++visited; });
            ASSERT_EQ(visited, within);
        }
        ASSERT_EQ(grid.size(), positions.size());
    }
}

TEST(VertexGrid, finds_what_brute_force_finds_under_churn)
{
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U})
        churn(box({-0.3, -0.2, -0.4}, {0.3, 0.2, 0.4}), seed, 50000);
}

TEST(VertexGrid, is_exact_in_flat_and_in_needle_shaped_bounds)
{
    churn(box({0, 0, 0}, {1, 1, 0}), 5, 20000);
    churn(box({0, 0, 0}, {1, 1e-7, 1e-9}), 6, 20000);
}

TEST(VertexGrid, gives_no_vertex_when_empty)
{
    VertexGrid grid(box({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(grid.nearest({0.5, 0.5, 0.5}), noVertex);
    grid.insert(7, {0.1, 0.1, 0.1});
    EXPECT_EQ(grid.nearest({0.5, 0.5, 0.5}), 7U);
    grid.erase(7);
    EXPECT_EQ(grid.nearest({0.5, 0.5, 0.5}, 7), noVertex);
}

TEST(VertexGrid, gives_the_lowest_id_of_vertices_at_the_same_place)
{
    VertexGrid grid(box({0, 0, 0}, {1, 1, 1}));
    for (const VertexId id : {5U, 3U, 9U})
        grid.insert(id, {0.5, 0.5, 0.5});
    EXPECT_EQ(grid.nearest({0.2, 0.9, 0.4}), 3U);
    EXPECT_EQ(grid.nearest({0.2, 0.9, 0.4}, 9), 3U);
}

} // namespace
} // namespace neuralmesh
