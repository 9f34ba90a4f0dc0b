// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/space/brute_force.h"

namespace neuralmesh {
namespace {

/// A search grid of these, by ids that are not their places.
PointGrid gridOf(const Box3 &bounds, const Positions &positions)
{
    std::vector<PointGrid::Entry> entries;
    for (const auto &[id, position] : positions)
        entries.push_back({position, id});
    std::reverse(entries.begin(), entries.end());
    return {bounds, std::move(entries)};
}

void finds(const Box3 &bounds, const Positions &positions, const std::vector<Point3> &queries)
{
    const PointGrid grid = gridOf(bounds, positions);
    const Scalar widest = bounds.Dim()[bounds.MaxDim()];
    for (const Point3 &query : queries) {
        const VertexId expected = nearestByBruteForce(positions, query);
        ASSERT_EQ(grid.nearest(query), expected);
        for (const VertexId known : {expected, positions.begin()->first}) {
            const Scalar d = (positions.at(known) - query).SquaredNorm();
            ASSERT_EQ(grid.nearest(query, {d, known}), expected) << "from " << known;
        }
        for (const Scalar radius : {0.01 * widest, 0.1 * widest, 0.7 * widest}) {
            const int within = countWithin(positions, query, radius);
            for (const int count : {1, 3, 40})
                ASSERT_EQ(grid.hasWithin(query, radius, count), within >= count);
            std::set<VertexId> visited;
            grid.forEachWithin(query, radius, [&](VertexId id) { visited.insert(id); });
            ASSERT_EQ(static_cast<int>(visited.size()), within);
        }
    }
}

void findsInBox(const Box3 &bounds, std::uint64_t seed, int count)
{
    Random random(seed);
    Positions positions;
    for (int i = 0; i < count; ++i)
        positions[static_cast<VertexId>(3 * i + 2)] = randomPoint(random, bounds);
    std::vector<Point3> queries;
    for (int i = 0; i < 300; ++i)
        queries.push_back(randomPoint(random, bounds));
    finds(bounds, positions, queries);
}

TEST(PointGrid, finds_what_brute_force_finds)
{
    for (const int count : {1, 2, 30, 2000})
        findsInBox(box({-0.3, -0.2, -0.4}, {0.3, 0.2, 0.4}), static_cast<std::uint64_t>(count),
                   count);
}

TEST(PointGrid, is_exact_in_flat_and_in_needle_shaped_bounds)
{
    findsInBox(box({0, 0, 0}, {1, 1, 0}), 5, 1000);
    findsInBox(box({0, 0, 0}, {1, 1e-7, 1e-9}), 6, 1000);
    findsInBox(box({1, 2, 3}, {1, 2, 3}), 7, 20);
}

TEST(PointGrid, is_exact_where_points_and_queries_lie_far_outside_the_bounds)
{
    Random random(8);
    Positions positions;
    std::vector<Point3> queries;
    for (VertexId id = 0; id < 500; ++id) {
        const Scalar far = id % 5 == 0 ? 1e7 : 1;
        positions[id] = randomPoint(random, box({0, 0, 0}, {1, 1, 1})) * far;
        queries.push_back(randomPoint(random, box({0, 0, 0}, {1, 1, 1})) * (id % 3 == 0 ? 1e9 : 1));
    }
    finds(box({0, 0, 0}, {1, 1, 1}), positions, queries);
}

TEST(PointGrid, keeps_cells_small_where_points_lie_on_a_surface)
{
    Random random(9);
    std::vector<Point3> points;
    for (int i = 0; i < 2000; ++i)
        points.emplace_back(random.unit(), random.unit(), 0.5);
    const PointGrid grid(box({0, 0, 0}, {1, 1, 1}), points);
    EXPECT_LE(grid.pointsInCell(), 4);
}

/// Nine of ten in a hundredth, a thousandth ... of the unit cube, some of them at one place.
Positions crowdedPositions(Random &random, VertexId count)
{
    Positions positions;
    for (VertexId id = 0; id < count; ++id) {
        const Scalar size = std::pow(10, -std::floor(6 * random.unit()));
        positions[id] = random.unit() < 0.1 ? Point3(0.2, 0.3, 0.4)
                                            : randomPoint(random, box({0, 0, 0}, {1, 1, 1})) * size;
    }
    return positions;
}

TEST(PointGrid, is_exact_where_points_crowd)
{
    Random random(10);
    const Box3 unitCube = box({0, 0, 0}, {1, 1, 1});
    const Positions positions = crowdedPositions(random, 3000);
    std::vector<Point3> queries;
    for (const auto &[id, position] : crowdedPositions(random, 200))
        queries.push_back(id % 5 == 0 ? position * 100 : position);
    EXPECT_TRUE(gridOf(unitCube, positions).isCrowded());
    finds(unitCube, positions, queries);
}

TEST(PointGrid, has_a_tree_only_where_points_crowd)
{
    Random random(11);
    Positions onSurface;
    for (VertexId id = 0; id < 3000; ++id)
        onSurface[id] = {random.unit(), random.unit() * random.unit(), 0.5};
    EXPECT_FALSE(gridOf(box({0, 0, 0}, {1, 1, 1}), onSurface).isCrowded());
}

TEST(PointGrid, gives_no_point_when_empty)
{
    const PointGrid grid(box({0, 0, 0}, {1, 1, 1}), std::vector<Point3>());
    EXPECT_EQ(grid.nearest({0.5, 0.5, 0.5}), noVertex);
    EXPECT_FALSE(grid.hasWithin({0.5, 0.5, 0.5}, 1));
}

TEST(PointGrid, gives_the_lowest_id_of_points_at_the_same_place)
{
    const Point3 place(0.5, 0.5, 0.5);
    const PointGrid grid(box({0, 0, 0}, {1, 1, 1}), {{place, 5}, {place, 3}, {place, 9}});
    EXPECT_EQ(grid.nearest({0.2, 0.9, 0.4}), 3U);
    EXPECT_EQ(grid.nearest({0.2, 0.9, 0.4}, {(place - Point3(0.2, 0.9, 0.4)).SquaredNorm(), 9}),
              3U);
}

} // namespace
} // namespace neuralmesh
