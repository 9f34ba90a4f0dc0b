// SPDX-License-Identifier: GPL-3.0-or-later
// Which collapses and splits even out valences, and the exchange that uses both.
#include <gtest/gtest.h>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "core/network/growing_network.h"
#include "core/network/regular_collapses.h"
#include "core/network/star_splits.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// Sum of squared differences from 6, on a boundary from 4.
int spreadOf(const NeuralMesh &mesh)
{
    int sum = 0;
    forEachVertex(mesh, [&](VertexId v) {
        const int excess = mesh.valence(v) - (mesh.isOnBoundary(v) ? 4 : 6);
        sum += excess * excess;
    });
    return sum;
}

/// A flat-sided torus with a vertex of valence 3 put into the middle of one face.
VertexId makeTorusWithAnExtraVertex(NeuralMesh &mesh)
{
    test::makeTorus(mesh, 40, 20);
    const NeighbourRing ring = mesh.ring(0);
    const VertexId a = ring[0];
    const VertexId b = ring[1];
    const VertexId v = mesh.addVertex((mesh.position(0) + mesh.position(a) + mesh.position(b)) / 3);
    for (const auto &[corner, next] : {std::pair{VertexId(0), a}, {a, b}, {b, VertexId(0)}})
        mesh.ring(corner).insert(mesh.ring(corner).find(next) + 1, v);
    for (const VertexId corner : {VertexId(0), a, b})
        mesh.ring(v).pushBack(corner);
    return v;
}

TEST(RegularCollapses, a_vertex_within_a_face_may_go)
{
    NeuralMesh mesh;
    const VertexId v = makeTorusWithAnExtraVertex(mesh);
    ASSERT_EQ(findDefect(mesh), "");
    EXPECT_NE(bestCollapseOnSurface(mesh, v), noVertex);
}

TEST(RegularCollapses, the_tip_of_a_limb_stays)
{
    NeuralMesh mesh;
    const VertexId v = makeTorusWithAnExtraVertex(mesh);
    mesh.position(v) += Point3(1, 0, 0) * 0.5; // far out of its face
    EXPECT_EQ(bestCollapseOnSurface(mesh, v), noVertex);
    EXPECT_NE(bestCollapse(mesh, v), noVertex) << "its connectivity alone would let it go";
}

TEST(StarSplits, a_boundary_edge_is_split_on_the_boundary_and_another_inside)
{
    NeuralMesh square;
    test::makeSquare(square, 4);
    forEachVertex(square, [&](VertexId v) {
        for (int edge = 0; edge < square.valence(v); ++edge)
            for (const StarSplit &star :
                 {halvingSplit(square, v, edge), balancedSplit(square, v, edge)}) {
                NeuralMesh mesh;
                mesh.copyNetwork(square);
                const VertexId other = mesh.ring(v)[edge];
                const bool isBoundary = isBoundaryEdge(mesh, v, other);
                const VertexId w = mesh.addVertex({0, 0, 0});
                split(mesh, star.vertex, star.first, star.last, w);
                ASSERT_EQ(findDefect(mesh), "") << v << " " << edge;
                EXPECT_EQ(mesh.isOnBoundary(w), isBoundary);
                EXPECT_TRUE(mesh.ring(w).contains(other));
                // The edge that is split is gone, between its ends there is w.
                EXPECT_FALSE(mesh.ring(v).contains(other));
            }
    });
}

TEST(StarSplits, the_balanced_split_leaves_least_spread_of_all)
{
    NeuralMesh square;
    test::makeSquare(square, 4);
    forEachVertex(square, [&](VertexId v) {
        for (int edge = 0; edge < square.valence(v); ++edge) {
            const auto spreadAfter = [&](const StarSplit &star) {
                NeuralMesh mesh;
                mesh.copyNetwork(square);
                split(mesh, v, star.first, star.last, mesh.addVertex({0, 0, 0}));
                return spreadOf(mesh);
            };
            const int found = spreadAfter(balancedSplit(square, v, edge));
            EXPECT_LE(found, spreadAfter(halvingSplit(square, v, edge))) << v << " " << edge;
            const NeighbourRing &ring = square.ring(v);
            if (!ring.isOpen() || ring.isBoundaryEdge(edge))
                continue;
            for (int first = 0; first < edge; ++first)
                for (int last = edge + 1; last < ring.size(); ++last)
                    EXPECT_LE(found, spreadAfter({v, first, last})) << v << " " << edge;
        }
    });
}

TEST(RegularCollapses, the_best_leaves_least_spread_of_all_on_a_boundary_too)
{
    NeuralMesh square;
    test::makeSquare(square, 4);
    for (const VertexId v : {VertexId(2), VertexId(6), VertexId(12), VertexId(24)}) {
        const VertexId best = bestCollapse(square, v);
        ASSERT_NE(best, noVertex) << v;
        const auto spreadAfter = [&](VertexId u) {
            NeuralMesh mesh;
            mesh.copyNetwork(square);
            const OppositeVertices opposite = oppositeVertices(mesh, v, u);
            collapse(mesh, v, u);
            int sum = 0;
            for (const VertexId x : {u, opposite.left, opposite.right})
                if (x != noVertex) {
                    const int excess = mesh.valence(x) - (mesh.isOnBoundary(x) ? 4 : 6);
                    sum += excess * excess;
                }
            return sum;
        };
        for (const VertexId u : square.ring(v))
            EXPECT_TRUE(!canCollapse(square, v, u) || spreadAfter(best) <= spreadAfter(u))
                << v << " into " << u;
    }
}

TEST(RegularCollapses, a_regular_mesh_has_none_that_gain)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 10, 8);
    EXPECT_TRUE(mostRegularCollapses(mesh).empty());
}

TEST(StarSplits, a_raising_split_gives_one_neighbour_more_and_lowers_the_sum)
{
    NeuralMesh mesh;
    const VertexId v = makeTorusWithAnExtraVertex(mesh);
    const StarSplit split = bestRaisingSplit(mesh, v);
    ASSERT_NE(split.vertex, noVertex);
    const int before = spreadOf(mesh);
    const VertexId w = mesh.addVertex(middleOfSpan(mesh, split));
    neuralmesh::split(mesh, split.vertex, split.first, split.last, w);
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(mesh.valence(v), 4);
    EXPECT_LT(spreadOf(mesh), before);
}

TEST(StarSplits, no_split_raises_where_all_are_regular)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 10, 8);
    EXPECT_EQ(bestRaisingSplit(mesh, 0).vertex, noVertex);
}

TEST(GrowingNetwork, exchanging_irregular_vertices_keeps_the_count_and_evens_valences)
{
    NeuralMesh mesh;
    makeTorusWithAnExtraVertex(mesh);
    Box3 bounds;
    for (const NeuralVertex &vertex : mesh.vert)
        bounds.Add(vertex.cP());
    GrowingNetwork network(mesh, bounds, GrowthParameters{});
    const int count = network.vertexCount();
    const int before = spreadOf(mesh);
    const std::vector<VertexId> made = network.exchangeIrregular();
    EXPECT_EQ(made.size(), 1U);
    EXPECT_EQ(network.vertexCount(), count);
    EXPECT_LT(spreadOf(mesh), before);
    EXPECT_EQ(findDefect(mesh), "");
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

} // namespace
} // namespace neuralmesh
