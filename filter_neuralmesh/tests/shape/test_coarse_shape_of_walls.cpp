// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/points_for_tests.h"
#include "tests/shape/coarse_shapes_for_tests.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

using test::expectShape;

/// The surface of a slab of 1 x 0.6, bent, thinner than a cell of the first grid.
test::Points plate()
{
    constexpr double thickness = 0.025;
    Random random(2);
    test::Points points;
    for (int i = 0; i < 8000; ++i) {
        double x = random.unit();
        double y = 0.6 * random.unit();
        double z = thickness * (random.unit() < 0.5 ? 0.5 : -0.5);
        if (i % 16 == 0) { // its rim
            (random.unit() < 0.5 ? x = std::round(x) : y = 0.6 * std::round(y / 0.6));
            z = thickness * (random.unit() - 0.5);
        }
        points.emplace_back(x, y, z + 0.1 * x * x);
    }
    return points;
}

TEST(CoarseShape, of_a_thin_plate_is_no_sheet)
{
    expectShape(plate(), 1, 0);
}

TEST(CoarseShape, of_both_sides_of_a_plate_has_no_holes)
{
    // Two and a half cells of the third grid thick; its edges have no points.
    Random random(1);
    test::Points sides;
    for (int i = 0; i < 20000; ++i) {
        const double x = random.unit();
        const double y = random.unit();
        sides.emplace_back(x, y, i % 2 == 0 ? 0 : 0.02);
    }
    NeuralMesh mesh;
    const CoarseShape shape = test::shapeOf(sides, mesh);
    EXPECT_TRUE(shape.isTrusted);
    EXPECT_EQ(shape.components, 1);
    EXPECT_EQ(shape.genus, 0);
}

/// The inside and the outside of a vase, an ellipsoid of half-axes 1, 1 and `height`, and its brim
/// around a round mouth on top.
test::Points vase(std::size_t count, double height, double thickness, double mouth)
{
    Random random(2);
    const double inner = 1 - thickness;
    test::Points points;
    for (const Point3 &p : test::spherePoints(count, 1)) {
        const double radius = random.unit() < 0.5 ? 1 : inner;
        if (p.Z() < 0 || radius * std::hypot(p.X(), p.Y()) > mouth)
            points.push_back(Point3(p.X(), p.Y(), height * p.Z()) * radius);
    }
    const double low = height * std::sqrt(inner * inner - mouth * mouth);
    const double high = height * std::sqrt(1 - mouth * mouth);
    for (std::size_t i = 0; i < count / 20; ++i) {
        const double angle = 2 * M_PI * random.unit();
        const double z = low + (high - low) * random.unit();
        points.emplace_back(mouth * std::cos(angle), mouth * std::sin(angle), z);
    }
    return points;
}

TEST(CoarseShape, finds_the_inner_wall_of_a_vase)
{
    // Two cells thick on the second grid; on the first, a membrane closes the mouth.
    expectShape(vase(20000, 1.5, 0.14, 0.7), 1, 0);
}

TEST(CoarseShape, parts_the_sides_of_thin_walls)
{
    // One and a half cells to two of the second grid. Most are closed by a lid without the third.
    for (const double thickness : {0.12, 0.14})
        for (const double height : {1.5, 2.0, 2.5}) {
            SCOPED_TRACE(testing::Message() << thickness << " " << height);
            expectShape(vase(20000, height, thickness, 0.6), 1, 0);
        }
}

TEST(CoarseShape, of_a_vase_of_few_points_has_no_lid)
{
    for (const double height : {1.0, 1.5, 2.0})
        for (const double thickness : {0.12, 0.14, 0.16}) {
            SCOPED_TRACE(testing::Message() << height << " " << thickness);
            expectShape(vase(3000, height, thickness, 0.8), 1, 0);
        }
}

TEST(CoarseShape, of_walls_as_thick_as_their_points_are_apart_has_no_tunnels)
{
    for (const std::size_t count : {3000, 4000, 5000})
        for (const double height : {1.0, 1.5}) {
            SCOPED_TRACE(testing::Message() << count << " " << height);
            expectShape(vase(count, height, 0.14, 0.8), 1, 0);
        }
}

} // namespace
} // namespace neuralmesh
