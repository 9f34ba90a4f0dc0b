// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/border_trimming.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/mesh/manifold_mesh.h"
#include "core/mesh/mesh_checks.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

constexpr int cells = 20;
constexpr TrimmingRadii radii{1.0 / cells, 0.5 / cells};

/// The unit square in the plane z = 0, in triangles.
TriangleSoup square()
{
    TriangleSoup soup;
    for (int x = 0; x <= cells; ++x)
        for (int y = 0; y <= cells; ++y)
            soup.points.push_back(Point3(x, y, 0) / cells);
    for (VertexId x = 0; x < cells; ++x)
        for (VertexId y = 0; y < cells; ++y) {
            const VertexId v = x * (cells + 1) + y;
            const VertexId across = v + cells + 2;
            soup.faces.push_back({v, v + cells + 1, across});
            soup.faces.push_back({v, across, v + 1});
        }
    return soup;
}

/// Of the square, those for which that holds; above it.
test::Points points(const std::function<bool(double, double)> &isThere)
{
    Random random(1);
    test::Points result;
    while (result.size() < 5000) {
        const double x = random.unit();
        const double y = random.unit();
        if (isThere(x, y))
            result.emplace_back(x, y, 0.5 / cells);
    }
    return result;
}

/// The boxes of the faces' centres are compared, and that they are a disc.
Box3 boxOfCentres(const TriangleSoup &soup, const std::vector<Corners> &faces)
{
    NeuralMesh mesh;
    makeManifold(mesh, soup.points, faces, Boundaries::allowed);
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.components, 1);
    EXPECT_EQ(topology.boundaryLoops, 1);
    EXPECT_EQ(topology.genus, 0);
    Box3 box;
    for (const Corners &c : faces)
        box.Add((soup.points[c[0]] + soup.points[c[1]] + soup.points[c[2]]) / 3);
    return box;
}

TEST(BorderTrimming, leaves_faces_as_far_as_points_reach_along_them)
{
    const TriangleSoup soup = square();
    const test::Points part =
        points([](double x, double y) { return x > 0.3 && x < 0.72 && y < 0.6; });
    const Box3 box = boxOfCentres(soup, trimBorders(soup, part, radii));
    EXPECT_NEAR(box.min.X(), 0.3, 1.0 / cells);
    EXPECT_NEAR(box.max.X(), 0.72, 1.0 / cells);
    EXPECT_NEAR(box.max.Y(), 0.6, 1.0 / cells);
    EXPECT_LT(box.min.Y(), 1.0 / cells);
}

TEST(BorderTrimming, leaves_a_gap_in_the_points_that_is_not_at_a_border)
{
    const TriangleSoup soup = square();
    const test::Points ring = points(
        [](double x, double y) { return std::max(std::abs(x - 0.5), std::abs(y - 0.5)) > 0.2; });
    EXPECT_EQ(trimBorders(soup, ring, radii).size(), soup.faces.size());
}

TEST(BorderTrimming, tears_nothing_off)
{
    const TriangleSoup soup = square();
    const test::Points parts = points([](double x, double) { return x < 0.4 || x > 0.6; });
    const std::vector<Corners> faces = trimBorders(soup, parts, radii);
    EXPECT_LT(faces.size(), soup.faces.size() * 9 / 10);
    const Box3 box = boxOfCentres(soup, faces);
    EXPECT_LT(box.min.X(), 1.0 / cells);
    EXPECT_GT(box.max.X(), 1 - 1.0 / cells);
}

TEST(BorderTrimming, leaves_a_closed_surface)
{
    TriangleSoup tetrahedron;
    tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    EXPECT_EQ(trimBorders(tetrahedron, test::Points{{5, 5, 5}}, radii).size(), 4U);
}

} // namespace
} // namespace neuralmesh
