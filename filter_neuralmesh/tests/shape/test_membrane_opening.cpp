// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/membrane_opening.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/mesh/manifold_mesh.h"
#include "core/mesh/mesh_checks.h"

namespace neuralmesh::test {
namespace {

/// The level set of a ball of radius 0.3 on a grid of 32 cells.
TriangleSoup ball()
{
    Grid f({32, 32, 32});
    for (int x = 0; x <= 32; ++x)
        for (int y = 0; y <= 32; ++y)
            for (int z = 0; z <= 32; ++z)
                f.at(x, y, z) =
                    static_cast<float>(0.3 - (Point3(x, y, z) / 32 - Point3(0.5, 0.5, 0.5)).Norm());
    return marchTetrahedra(f, 0, cellsBetween(f, 0, 0));
}

/// Its points, but for those higher than that.
std::vector<Point3> pointsBelow(const TriangleSoup &soup, double height)
{
    std::vector<Point3> points;
    for (const Point3 &p : soup.points)
        if (p.Z() < height)
            points.push_back(p);
    return points;
}

TopologyFigures topologyOf(const TriangleSoup &soup, const std::vector<Corners> &faces)
{
    NeuralMesh mesh;
    makeManifold(mesh, soup.points, faces, Boundaries::allowed);
    validate(mesh);
    return measureTopology(mesh);
}

constexpr SupportRadii usual{1.0 / 32, 2.0 / 32};

MembraneOpening opened(const TriangleSoup &soup, const std::vector<Point3> &points,
                       double leastArea, const SupportRadii &radii = usual)
{
    return openMembranes(soup, measureSupport(soup, points, radii).ofFace, leastArea);
}

TEST(MembraneOpening, opens_a_ball_where_it_has_no_points)
{
    const TriangleSoup soup = ball();
    const MembraneOpening opening = opened(soup, pointsBelow(soup, 0.5), 0.01);
    EXPECT_EQ(opening.openings, 1);
    const TopologyFigures topology = topologyOf(soup, opening.faces);
    EXPECT_EQ(topology.components, 1);
    EXPECT_EQ(topology.boundaryLoops, 1);
    EXPECT_EQ(topology.genus, 0);
}

TEST(MembraneOpening, leaves_what_points_support)
{
    const TriangleSoup soup = ball();
    const MembraneOpening opening = opened(soup, soup.points, 0.01);
    EXPECT_EQ(opening.openings, 0);
    EXPECT_EQ(opening.faces.size(), soup.faces.size());
}

TEST(MembraneOpening, leaves_a_gap_that_is_smaller_than_the_least_area)
{
    const TriangleSoup soup = ball();
    const std::vector<Point3> points = pointsBelow(soup, 0.73); // a cap of an area of 0.13
    EXPECT_EQ(opened(soup, points, 0.2).openings, 0);
    EXPECT_EQ(opened(soup, points, 0.05).openings, 1);
}

TEST(MembraneOpening, leaves_one_fan_of_faces_at_each_vertex)
{
    // Two halves of the ball that would touch in single vertices, where a band between them, too
    // narrow to be far from all points, runs to a tip.
    const TriangleSoup soup = ball();
    std::vector<Point3> points;
    for (const Point3 &p : soup.points)
        if (std::abs(p.Z() - 0.5) > 0.15 * std::abs(p.X() - 0.5) + 0.03)
            points.push_back(p);
    const MembraneOpening opening = opened(soup, points, 0.0001, {0.5 / 32, 1.2 / 32});
    EXPECT_GT(opening.openings, 0);
    topologyOf(soup, opening.faces); // throws where several fans meet
}

} // namespace
} // namespace neuralmesh::test
