// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/loop_triangulation.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace neuralmesh {
namespace {

/// Any weights will do, as long as they differ.
double someWeight(int i, int j, int k)
{
    return 1 + (i * 7919 + j * 104729 + k * 1299709) % 1009;
}

/// Over all triangulations.
double leastByBruteForce(int i, int j)
{
    if (j - i < 2)
        return 0;
    double least = std::numeric_limits<double>::infinity();
    for (int apex = i + 1; apex < j; ++apex)
        least = std::min(least, leastByBruteForce(i, apex) + leastByBruteForce(apex, j) +
                                    someWeight(i, apex, j));
    return least;
}

TEST(LoopTriangulation, is_the_lightest_of_all)
{
    for (int size = 3; size < 11; ++size) {
        const LoopTriangulation found = triangulateLoop(size, someWeight);
        double sum = 0;
        for (const LoopTriangle &t : found.triangles)
            sum += someWeight(t[0], t[1], t[2]);
        EXPECT_EQ(found.triangles.size(), static_cast<std::size_t>(size - 2));
        EXPECT_EQ(found.weight, sum);
        EXPECT_EQ(found.weight, leastByBruteForce(0, size - 1));
    }
}

TEST(LoopTriangulation, takes_no_forbidden_triangle)
{
    const double infinite = std::numeric_limits<double>::infinity();
    const auto withoutDiagonal02 = [=](int i, int, int k) {
        return i == 0 && k == 2 ? infinite : 1.0;
    };
    const LoopTriangulation found = triangulateLoop(4, withoutDiagonal02);
    ASSERT_EQ(found.triangles.size(), 2U);
    for (const LoopTriangle &t : found.triangles)
        EXPECT_FALSE(t[0] == 0 && t[2] == 2);
    const auto nothing = [=](int, int, int) { return infinite; };
    EXPECT_TRUE(triangulateLoop(5, nothing).triangles.empty());
}

} // namespace
} // namespace neuralmesh
