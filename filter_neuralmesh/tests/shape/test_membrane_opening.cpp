// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/membrane_opening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
    // Two of the faces around a vertex are membranes, opposite each other: what stays would meet
    // in that vertex only.
    const TriangleSoup soup = ball();
    NeuralMesh mesh;
    makeManifold(mesh, soup.points, soup.faces);
    VertexId v = 0;
    while (mesh.ring(v).size() != 6)
        ++v;
    const auto hasCorners = [](const Corners &face, VertexId a, VertexId b, VertexId c) {
        return std::is_permutation(face.begin(), face.end(), std::array{a, b, c}.begin());
    };
    std::vector<Support> support(soup.faces.size(), Support::near);
    const auto &ring = mesh.ring(v);
    for (FaceId f = 0; f < soup.faces.size(); ++f)
        if (hasCorners(soup.faces[f], v, ring[0], ring[1]) ||
            hasCorners(soup.faces[f], v, ring[3], ring[4]))
            support[f] = Support::far;
    const MembraneOpening opening = openMembranes(soup, support, 0);
    EXPECT_EQ(opening.openings, 2);
    EXPECT_EQ(opening.faces.size(), soup.faces.size() - 4);           // and the two of one fan
    const TopologyFigures topology = topologyOf(soup, opening.faces); // throws at a pinch
    EXPECT_EQ(topology.components, 1);
    EXPECT_EQ(topology.boundaryLoops, 1);
    EXPECT_EQ(topology.genus, 0);
}

} // namespace
} // namespace neuralmesh::test
