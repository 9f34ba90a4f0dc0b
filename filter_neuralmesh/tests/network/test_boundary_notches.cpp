// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/boundary_notches.h"

#include <gtest/gtest.h>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// A square of 4 by 4 with a slit of one quad from the middle of its lower side up, as wide as
/// `width` of the quad.
///
///     +-------+
///     |       |
///     |   A   |  the slit's tip has two corners, A and the next
///     |  | |  |
///     +--+ +--+
void makeSlit(NeuralMesh &mesh, Scalar width)
{
    test::makeSquare(mesh, 5);
    // Quads (2, 0) and (2, 1): the lower side's middle.
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    for (const NeuralVertex &vertex : mesh.vert)
        points.push_back(vertex.cP());
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        const Point3 middle = (points[a] + points[b] + points[c]) / 3;
        if (middle.X() < 2 || middle.X() > 3 || middle.Y() > 2)
            faces.push_back({a, b, c});
    });
    for (const VertexId row : {0U, 1U, 2U}) {
        points[row * 6 + 2].X() = 2.5 - width / 2;
        points[row * 6 + 3].X() = 2.5 + width / 2;
    }
    test::makeMesh(mesh, points, faces);
}

TEST(BoundaryNotches, a_slit_is_closed_like_a_zip)
{
    NeuralMesh mesh;
    makeSlit(mesh, 0.02);
    ASSERT_EQ(findDefect(mesh), "");
    EXPECT_EQ(fillNotches(mesh), 4); // two faces for each row
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.boundaryLoops, 1);
    EXPECT_EQ(topology.genus, 0);
    for (const VertexId v : {14U, 15U, 8U, 9U}) // from the tip down, but for the opening
        EXPECT_FALSE(mesh.isOnBoundary(v)) << v;
}

TEST(BoundaryNotches, corners_and_wide_bays_stay)
{
    NeuralMesh mesh;
    makeSlit(mesh, 1); // a bay with right angles
    EXPECT_EQ(fillNotches(mesh), 0);
    test::makeSquare(mesh, 3);
    mesh.position(15) = {9, 9, 0}; // a spike: as sharp, but the surface is inside
    EXPECT_FALSE(isNotch(mesh, 15));
    EXPECT_EQ(fillNotches(mesh), 0);
}

TEST(BoundaryNotches, a_hole_of_three_edges_stays)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 6, 6);
    const VertexId a = mesh.ring(0)[0];
    const VertexId b = mesh.ring(0)[1];
    openDisc(mesh, {0, a, b}, {});
    fillNotches(mesh);
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
}

} // namespace
} // namespace neuralmesh
