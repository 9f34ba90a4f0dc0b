// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/vertex_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "neuralmesh/random.h"

namespace neuralmesh {
namespace {

using Positions = std::map<VertexId, Point3>;

/// The oracle: every vertex looked at, ties to the lowest id.
VertexId nearestByBruteForce(const Positions &positions, const Point3 &query)
{
    VertexId best = noVertex;
    Scalar least = 0;
    for (const auto &[id, position] : positions) {
        const Scalar d = (position - query).SquaredNorm();
        if (best == noVertex || d < least) {
            best = id;
            least = d;
        }
    }
    return best;
}

Box3 box(const Point3 &low, const Point3 &high)
{
    Box3 b;
    b.Add(low);
    b.Add(high);
    return b;
}

/// Points in and around the box, a part of them on a coarse lattice so that ties occur.
Point3 randomPoint(Random &random, const Box3 &bounds)
{
    Point3 p;
    const bool onLattice = random.below(4) == 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = onLattice ? static_cast<double>(random.below(9)) / 8 : random.unit();
        p[axis] = bounds.min[axis] + (1.4 * along - 0.2) * bounds.Dim()[axis];
    }
    return p;
}

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
            const auto within = std::count_if(positions.begin(), positions.end(), [&](auto &entry) {
                return (entry.second - p).SquaredNorm() <= radius * radius;
            });
            ASSERT_EQ(grid.hasWithin(p, radius), within >= 1);
            ASSERT_EQ(grid.hasWithin(p, radius, 3), within >= 3);
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
