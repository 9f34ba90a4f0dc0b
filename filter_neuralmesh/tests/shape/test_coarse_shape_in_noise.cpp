// SPDX-License-Identifier: GPL-3.0-or-later
// What noise does to the shape that is found. The tests are of the suite of test_coarse_shape.cpp.
#include <gtest/gtest.h>

#include "tests/points_for_tests.h"
#include "tests/shape/coarse_shapes_for_tests.h"

namespace neuralmesh {
namespace {

using test::shapeOf;

/// The two sides of a wedge of 1 x 0.6, 0.004 thick at its edge and 0.022 at its back, in noise.
test::Points noisyWedge()
{
    Random random(2);
    test::Points points;
    for (int i = 0; i < 40000; ++i) {
        const double x = random.unit();
        const double half = 0.002 + 0.009 * x;
        points.emplace_back(x, 0.6 * random.unit(), random.unit() < 0.5 ? half : -half);
        if (i % 25 == 0) // its back
            points.back() = Point3(1, points.back().Y(), 0.011 * (2 * random.unit() - 1));
    }
    return test::withNoise(points, 0.003, 3);
}

TEST(CoarseShape, of_a_wedge_is_no_sheet_where_a_fine_grid_sees_one_side_at_a_time)
{
    NeuralMesh mesh;
    const CoarseShape shape = shapeOf(noisyWedge(), mesh);
    EXPECT_FALSE(shape.isSheet);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.genus, 0);
    EXPECT_LT(shape.unsupportedShare, 0.01);
}

/// A bar of 40 x 20 x `height` with two slits through it, with normally distributed noise of so
/// many hundredths of its length, and strays in its box.
test::Points slitBar(int height, std::size_t count, double noise, int strays)
{
    const auto isSolid = [&](int x, int y, int z) {
        const bool isSlit = (x >= 8 && x < 11) || (x >= 29 && x < 32);
        return z < height && y < 20 && !(isSlit && y > 6 && y < 13);
    };
    test::Points points = test::latticePoints(count, 40, isSolid, 1);
    Box3 box;
    for (const Point3 &p : points)
        box.Add(p);
    points = test::withNoise(points, noise / 100 * box.DimX(), 5);
    Random random(5);
    for (int i = 0; i < strays; ++i)
        points.push_back(box.min + Point3(random.unit() * box.DimX(), random.unit() * box.DimY(),
                                          random.unit() * box.DimZ()));
    return points;
}

void expectSlitsOnGrid(int cells, const test::Points &points)
{
    NeuralMesh mesh;
    const CoarseShape shape = shapeOf(points, mesh);
    EXPECT_EQ(shape.cells, cells);
    EXPECT_TRUE(shape.isTrusted);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.genus, 2);
}

TEST(CoarseShape, is_not_of_a_grid_whose_cells_are_smaller_than_the_noise)
{
    expectSlitsOnGrid(32, slitBar(8, 20000, 2, 0));
}

TEST(CoarseShape, is_not_of_a_grid_whose_levels_noise_and_strays_part)
{
    expectSlitsOnGrid(64, slitBar(5, 10000, 0.9, 600));
}

/// Points all over a cube, of which no surface explains more than a few: rounds more on the second
/// grid lead to two hundred handles, and are taken back.
TEST(CoarseShape, of_a_solid_cube_has_no_handles)
{
    Random random(1);
    test::Points points;
    for (int i = 0; i < 20000; ++i) {
        const double x = random.unit();
        const double y = random.unit();
        points.emplace_back(x, y, random.unit());
    }
    NeuralMesh mesh;
    const CoarseShape shape = test::shapeOf(points, mesh);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.genus, 0);
}

} // namespace
} // namespace neuralmesh
