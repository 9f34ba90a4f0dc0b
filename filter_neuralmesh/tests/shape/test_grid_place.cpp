// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/grid_place.h"

#include <gtest/gtest.h>

#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

/// Not a cube, so that no axis can stand for another.
constexpr GridSize cells{8, 12, 16};
constexpr int resolution = 16;

/// Anywhere in the grid's box, so many cells from its border or more.
test::Points places(std::size_t count, double margin, std::uint64_t seed)
{
    Random random(seed);
    const auto along = [&](int axisCells) {
        return (margin + random.unit() * (axisCells - 2 * margin)) / resolution;
    };
    test::Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = along(cells.x);
        const double y = along(cells.y);
        points.emplace_back(x, y, along(cells.z));
    }
    return points;
}

TEST(GridPlace, interpolates_a_trilinear_function_exactly)
{
    const auto trilinear = [](const Point3 &p) {
        return (1 + p.X()) * (2 - p.Y()) * (3 * p.Z() - 1) + p.X();
    };
    const Grid grid = test::sampled(cells, trilinear);
    test::Points points = places(100, 0, 1);
    points.emplace_back(0, 0, 0);
    points.push_back(Point3(cells.x, cells.y, cells.z) / resolution); // the last corner
    for (const Point3 &p : points)
        EXPECT_NEAR(interpolate(grid, placeInGrid(grid, p)), trilinear(p), 1e-5); // rounding
}

TEST(GridPlace, the_gradient_of_a_linear_function_is_its_slope_by_the_cell)
{
    const Grid grid =
        test::sampled(cells, [](const Point3 &p) { return 2 * p.X() - 3 * p.Y() + 5 * p.Z(); });
    for (const Point3 &p : places(100, 1, 2)) {
        const vcg::Point3f gradient = gradientAt(grid, placeInGrid(grid, p));
        EXPECT_NEAR(gradient.X(), 2.0 / resolution, 1e-5);
        EXPECT_NEAR(gradient.Y(), -3.0 / resolution, 1e-5);
        EXPECT_NEAR(gradient.Z(), 5.0 / resolution, 1e-5);
    }
}

// <A x, y> = <x, A* y>. Of a few hundred products in single precision, each below 1.
constexpr double rounding = 1e-4;

TEST(GridPlace, splat_is_the_adjoint_of_interpolate)
{
    const Grid f = test::noise(cells, 3);
    Grid spread(cells);
    double right = 0;
    Random random(4);
    for (const Point3 &p : places(300, 0, 5)) {
        const GridPlace place = placeInGrid(f, p);
        const double weight = 2 * random.unit() - 1;
        right += static_cast<double>(interpolate(f, place)) * weight;
        splat(spread, place, static_cast<float>(weight));
    }
    EXPECT_NEAR(test::dot(f, spread), right, rounding);
    EXPECT_GT(std::abs(right), 0.1) << "Nothing is compared.";
}

TEST(GridPlace, splat_divergence_is_the_adjoint_of_minus_the_gradient)
{
    // By axis, so that no component can make up for another.
    for (int axis = 0; axis < 3; ++axis) {
        const Grid f = test::noise(cells, 6);
        Grid spread(cells);
        double right = 0;
        Random random(7);
        for (const Point3 &p : places(300, 1, 8)) {
            const GridPlace place = placeInGrid(f, p);
            vcg::Point3f vector(0, 0, 0);
            vector[axis] = static_cast<float>(2 * random.unit() - 1);
            right += static_cast<double>(gradientAt(f, place) * vector);
            splatDivergence(spread, place, vector);
        }
        EXPECT_NEAR(test::dot(f, spread), -right, rounding) << "axis " << axis;
        EXPECT_GT(std::abs(right), 0.1) << "Nothing is compared.";
    }
}

} // namespace
} // namespace neuralmesh
