// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_surgery.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/boundary.h"
#include "core/mesh/mesh_checks.h"
#include "core/topology/handle_loop.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// Once round two triangles, one step on each in turn.
const std::vector<std::pair<int, int>> prism = {{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 1}, {0, 1}};

void makeTwoOctahedra(NeuralMesh &mesh)
{
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    for (VertexId k = 0; k < 2; ++k) {
        NeuralMesh one;
        test::makeOctahedron(one);
        const FaceTable table(one);
        for (const NeuralVertex &vertex : one.vert)
            points.push_back(vertex.cP() + Point3(0, 0, 5.0 * k));
        for (FaceId face = 0; face < table.size(); ++face) {
            const Corners c = table.corners(face);
            faces.push_back({{c[0] + 6 * k, c[1] + 6 * k, c[2] + 6 * k}});
        }
    }
    test::makeMesh(mesh, points, faces);
}

TEST(RingSurgery, a_bridge_joins_two_components)
{
    NeuralMesh mesh;
    makeTwoOctahedra(mesh);
    // The faces (0, 2, 4) and (6, 8, 10), one in each.
    bridgeDiscs(mesh, {0, 2, 4}, {6, 8, 10}, prism);
    EXPECT_EQ(findDefect(mesh), "");
    const TopologyFigures figures = measureTopology(mesh);
    EXPECT_EQ(figures.components, 1);
    EXPECT_EQ(figures.genus, 0);
    EXPECT_EQ(figures.faces, 8 + 8 - 2 + 6);
}

TEST(RingSurgery, a_bridge_within_a_component_makes_a_handle)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 8, 6);
    const FaceTable faces(mesh);
    const Corners a = faces.corners(0);
    const FaceId far = faces.leftOf(4 * 6 + 3, 5 * 6 + 3);
    const Corners b = faces.corners(far);
    bridgeDiscs(mesh, {a.begin(), a.end()}, {b.begin(), b.end()}, prism);
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).genus, 2);
    EXPECT_EQ(measureTopology(mesh).components, 1);
}

TEST(RingSurgery, a_cut_round_a_handle_leaves_a_sphere_when_both_ends_are_closed)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 8, 5);
    const std::vector<VertexId> loop{0, 1, 2, 3, 4}; // round the tube
    ASSERT_TRUE(canCut(mesh, loop));
    const std::vector<VertexId> copies = cutOpen(mesh, loop);
    const std::vector<LoopTriangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    refillDisc(mesh, copies, {}, fan);
    refillDisc(mesh, {loop.rbegin(), loop.rend()}, {}, fan);
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).genus, 0);
    EXPECT_EQ(measureTopology(mesh).components, 1);
    EXPECT_EQ(mesh.vn, 8 * 5 + 5);
}

TEST(RingSurgery, a_cut_next_to_a_single_face_is_refused)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    EXPECT_FALSE(canCut(mesh, {0, 2, 4}));   // a face: nothing is left on its inner side
    EXPECT_TRUE(canCut(mesh, {0, 2, 1, 3})); // the equator
}

TEST(RingSurgery, a_disc_that_is_opened_leaves_a_hole_and_filling_it_brings_the_mesh_back)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 6, 6);
    const std::vector<VertexId> rim(mesh.ring(14).begin(), mesh.ring(14).end());
    ASSERT_TRUE(canOpenDisc(mesh, rim));
    openDisc(mesh, rim, {14});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(mesh.vn, 35);
    const TopologyFigures open = measureTopology(mesh);
    EXPECT_EQ(open.boundaryLoops, 1);
    EXPECT_EQ(open.genus, 1);
    EXPECT_EQ(open.faces, 72 - 6);
    // The hole's rim is the boundary walked backwards.
    std::vector<VertexId> hole = boundaryLoops(mesh).front();
    std::reverse(hole.begin(), hole.end());
    refillDisc(mesh, hole, {}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 0);
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

TEST(RingSurgery, holes_that_are_bridged_make_a_handle)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 8, 6);
    const FaceTable faces(mesh);
    const Corners a = faces.corners(0);
    const Corners b = faces.corners(faces.leftOf(4 * 6 + 3, 5 * 6 + 3));
    openDisc(mesh, {a.begin(), a.end()}, {});
    openDisc(mesh, {b.begin(), b.end()}, {});
    ASSERT_EQ(findDefect(mesh), "");
    ASSERT_EQ(measureTopology(mesh).boundaryLoops, 2);
    bridgeDiscs(mesh, {a.begin(), a.end()}, {b.begin(), b.end()}, prism);
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 0);
    EXPECT_EQ(measureTopology(mesh).genus, 2);
}

TEST(RingSurgery, a_tube_is_a_cut_that_is_not_closed)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 8, 5);
    cutOpen(mesh, {0, 1, 2, 3, 4});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 2);
    EXPECT_EQ(measureTopology(mesh).genus, 0);
}

TEST(RingSurgery, a_disc_at_the_boundary_is_filled_anew)
{
    // The two faces of a corner's quad get the other diagonal.
    NeuralMesh mesh;
    test::makeSquare(mesh, 2);
    refillDisc(mesh, {0, 1, 4, 3}, {}, {{0, 1, 3}, {1, 2, 3}});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_FALSE(mesh.ring(0).contains(4));
    EXPECT_TRUE(mesh.ring(1).contains(3));
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
}

TEST(RingSurgery, a_disc_that_touches_a_boundary_is_not_opened)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 3);
    EXPECT_TRUE(canOpenDisc(mesh, {5, 6, 10, 9})); // the quad in the middle
    EXPECT_FALSE(canOpenDisc(mesh, {0, 1, 5, 4}));
    openDisc(mesh, {5, 6, 10, 9}, {});
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 2);
}

TEST(HandleLoops, a_sphere_has_none)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    EXPECT_TRUE(handleLoops(mesh, FaceTable(mesh), 0).empty());
}

TEST(HandleLoops, a_torus_has_two_and_the_shortest_goes_round_the_tube)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 12, 5);
    for (const VertexId root : {0U, 17U, 44U}) {
        const auto loops = handleLoops(mesh, FaceTable(mesh), root);
        ASSERT_EQ(loops.size(), 2U);
        EXPECT_EQ(loops[0].size(), 5U); // as many as the tube has places
        for (const std::vector<VertexId> &loop : loops)
            for (std::size_t k = 0; k < loop.size(); ++k)
                EXPECT_TRUE(mesh.ring(loop[k]).contains(loop[(k + 1) % loop.size()]));
    }
}

} // namespace
} // namespace neuralmesh
