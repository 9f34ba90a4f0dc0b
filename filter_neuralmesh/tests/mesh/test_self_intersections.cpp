// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/self_intersections.h"

#include <gtest/gtest.h>

#include "core/mesh/enumeration.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// Four faces around vertex 0, of which 0 1 2 passes through 0 4 5:
///
///      3---2      2 is above the plane of the others, 1 below it, beyond 4 and 5: the edge between
///     / \ /       them passes through the middle of 0 4 5
///    4---0
///     \ /
///  1   5
void makeFanThroughItself(NeuralMesh &mesh, Scalar size)
{
    std::vector<Point3> points = {{0, 0, 0},       {-1.5, -1.45, -0.5}, {0.5, 0.87, 0.5},
                                  {-0.5, 0.87, 0}, {-1, 0, 0},          {-0.5, -0.87, 0}};
    for (Point3 &p : points)
        p *= size;
    test::makeMesh(mesh, points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
}

TEST(SelfIntersections, faces_that_share_a_vertex_cross_whatever_their_size)
{
    for (const Scalar size : {1.0, 1e-3, 1e-6}) {
        NeuralMesh mesh;
        makeFanThroughItself(mesh, size);
        const SelfIntersections found = findSelfIntersections(mesh);
        EXPECT_EQ(found.faces, 2) << size;
        EXPECT_EQ(found.corners, (std::vector<VertexId>{0, 1, 2, 4, 5})) << size;
    }
}

TEST(SelfIntersections, a_face_that_crosses_several_counts_once)
{
    // A strip of two crosses another of two, in a row: four pairs.
    NeuralMesh mesh;
    test::makeMesh(mesh,
                   {{-1, -1, 0},
                    {1, -1, 0},
                    {1, 1, 0},
                    {-1, 1, 0},
                    {-0.5, -2, -1},
                    {-0.3, 0.1, -1},
                    {0.1, 0.3, 1},
                    {-0.4, -0.2, 1}},
                   {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    EXPECT_EQ(findSelfIntersections(mesh).faces, 4);
}

/// Two triangles in one tilted plane, the second moved along it.
int crossingInPlane(Scalar along, bool isTurned)
{
    const Point3 x(0.6, 0.3, 0.2);
    const Point3 y(-0.2, 0.7, 0.4);
    const auto corner = [&](Scalar a, Scalar b) { return (x * a + y * b) * 1e-3; };
    NeuralMesh mesh;
    test::makeMesh(mesh,
                   {corner(0, 0), corner(1, 0), corner(0, 1), corner(along, 0),
                    corner(along + 1, 0), corner(along, 1)},
                   {{0, 1, 2}, isTurned ? Corners{3, 5, 4} : Corners{3, 4, 5}});
    return findSelfIntersections(mesh).faces;
}

TEST(SelfIntersections, faces_upon_each_other_in_one_plane_cross)
{
    for (const bool isTurned : {false, true}) {
        EXPECT_EQ(crossingInPlane(0, isTurned), 2);
        EXPECT_EQ(crossingInPlane(0.3, isTurned), 2);
        EXPECT_EQ(crossingInPlane(1, isTurned), 0); // a corner in common
        EXPECT_EQ(crossingInPlane(1.2, isTurned), 0);
    }
}

TEST(SelfIntersections, neighbours_in_a_tilted_plane_do_not_cross)
{
    // The rounding of their coordinates puts corners on either side of the others' planes.
    NeuralMesh mesh;
    test::makeSquare(mesh, 12);
    forEachVertex(mesh, [&](VertexId v) {
        const Point3 p = mesh.position(v);
        mesh.position(v) = Point3(p[0] * 0.6, p[1] * 0.7, (p[0] + p[1] * 1.3) / 3);
    });
    EXPECT_EQ(findSelfIntersections(mesh).faces, 0);
}

} // namespace
} // namespace neuralmesh
