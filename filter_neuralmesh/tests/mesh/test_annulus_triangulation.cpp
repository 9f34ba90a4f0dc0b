// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/annulus_triangulation.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {
namespace {

/// A circle of radius 1 at a height, walked one way or the other, its first place turned.
std::vector<Point3> circle(int size, Scalar height, int direction, Scalar turn)
{
    std::vector<Point3> points;
    for (int i = 0; i < size; ++i) {
        const Scalar angle = 2 * M_PI * (direction * i + turn) / size;
        points.emplace_back(std::cos(angle), std::sin(angle), height);
    }
    return points;
}

Scalar area(const Point3 &a, const Point3 &b, const Point3 &c)
{
    return ((b - a) ^ (c - a)).Norm() / 2;
}

AnnulusWeights areas(const std::vector<Point3> &first, const std::vector<Point3> &second)
{
    const auto at = [](const std::vector<Point3> &loop, int i) {
        const auto size = static_cast<int>(loop.size());
        return loop[static_cast<std::size_t>((i + size) % size)];
    };
    return {[=](int i, int j) { return area(at(first, i), at(first, i + 1), at(second, j)); },
            [=](int i, int j) { return area(at(second, j - 1), at(second, j), at(first, i)); }};
}

TEST(AnnulusTriangulation, goes_round_both_loops_once)
{
    const std::vector<Point3> first = circle(7, 0, 1, 0);
    const std::vector<Point3> second = circle(4, 1, -1, 0);
    const AnnulusTriangulation found = triangulateAnnulus(7, 4, areas(first, second));
    ASSERT_EQ(found.rungs.size(), 11U);
    int steps[2] = {0, 0};
    for (std::size_t k = 0; k < found.rungs.size(); ++k) {
        const auto [i, j] = found.rungs[k];
        const auto [nextI, nextJ] = found.rungs[(k + 1) % found.rungs.size()];
        const bool forward = nextI == (i + 1) % 7 && nextJ == j;
        const bool back = nextI == i && nextJ == (j + 3) % 4;
        EXPECT_TRUE(forward != back) << k;
        ++steps[back ? 1 : 0];
    }
    EXPECT_EQ(steps[0], 7);
    EXPECT_EQ(steps[1], 4);
}

TEST(AnnulusTriangulation, finds_the_twist_of_least_area_whatever_the_start)
{
    // A prism's wall has 2 n triangles of half a side's area each; twisted, it has more.
    constexpr int size = 8;
    const Scalar side = 2 * std::sin(M_PI / size);
    for (int turn = 0; turn < size; ++turn) {
        const AnnulusTriangulation found =
            triangulateAnnulus(size, size, areas(circle(size, 0, 1, 0), circle(size, 1, -1, turn)));
        EXPECT_NEAR(found.weight, size * side, 1e-9) << turn;
    }
}

TEST(AnnulusTriangulation, gives_up_where_everything_is_forbidden)
{
    const auto never = [](int, int) { return std::numeric_limits<double>::infinity(); };
    EXPECT_TRUE(triangulateAnnulus(3, 3, {never, never}).rungs.empty());
}

TEST(AnnulusTriangulation, takes_no_edge_twice)
{
    // Forward on the first is free only at place 0 of the second, so that all rungs lie there.
    const AnnulusWeights fans{[](int, int j) { return j == 0 ? 0.0 : 100.0; },
                              [](int i, int) { return i == 0 ? 0.0 : 100.0; }};
    const AnnulusTriangulation found = triangulateAnnulus(3, 3, fans);
    const std::set<std::pair<int, int>> distinct(found.rungs.begin(), found.rungs.end());
    EXPECT_EQ(distinct.size(), found.rungs.size());
}

} // namespace
} // namespace neuralmesh
