// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/ring_topology.h"

#include <gtest/gtest.h>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/update/topology.h>

#include <set>

#include "core/mesh/boundary.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

using test::makeBipyramid;
using test::makeOctahedron;
using test::makeSquare;
using test::makeTorus;
using test::makeTube;

std::vector<VertexId> liveVertices(const NeuralMesh &mesh)
{
    std::vector<VertexId> live;
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        if (mesh.isLive(v))
            live.push_back(v);
    return live;
}

/// What has to stay the same of a mesh, as VCG counts it.
struct VcgFigures {
    int euler, boundaries, components;

    explicit VcgFigures(NeuralMesh &mesh)
    {
        vcg::tri::UpdateTopology<NeuralMesh>::FaceFace(mesh);
        int edges = 0;
        int boundaryEdges = 0;
        int nonManifoldEdges = 0;
        vcg::tri::Clean<NeuralMesh>::CountEdgeNum(mesh, edges, boundaryEdges, nonManifoldEdges);
        euler = nonManifoldEdges > 0 ? -1000000 : mesh.vn - edges + mesh.fn;
        boundaries = vcg::tri::Clean<NeuralMesh>::CountHoles(mesh);
        components = vcg::tri::Clean<NeuralMesh>::CountConnectedComponents(mesh);
    }
    bool operator==(const VcgFigures &other) const
    {
        return euler == other.euler && boundaries == other.boundaries &&
               components == other.components;
    }
};

/// What VCG says of the mesh that plain index replacement leaves of edge (v, u): two-manifold, no
/// doubled or degenerate face, no vertex lost but v, topology kept.
bool vcgAcceptsCollapse(NeuralMesh &source, VertexId v, VertexId u)
{
    using Clean = vcg::tri::Clean<NeuralMesh>;
    using Allocator = vcg::tri::Allocator<NeuralMesh>;
    NeuralMesh mesh;
    for (const NeuralVertex &vertex : source.vert)
        Allocator::AddVertex(mesh, vertex.cP());
    for (const NeuralFace &face : source.face) {
        VertexId id[3];
        int ends = 0;
        for (int corner = 0; corner < 3; ++corner) {
            id[corner] = static_cast<VertexId>(vcg::tri::Index(source, face.cV(corner)));
            ends += id[corner] == v || id[corner] == u ? 1 : 0;
            id[corner] = id[corner] == v ? u : id[corner];
        }
        if (ends < 2)
            Allocator::AddFace(mesh, id[0], id[1], id[2]);
    }
    if (Clean::RemoveDuplicateFace(mesh) > 0)
        return false;
    Clean::RemoveUnreferencedVertex(mesh);
    vcg::tri::UpdateTopology<NeuralMesh>::FaceFace(mesh);
    return mesh.vn == source.vn - 1 && Clean::CountNonManifoldVertexFF(mesh) == 0 &&
           VcgFigures(mesh) == VcgFigures(source);
}

void compareCollapsesWithVcg(NeuralMesh &mesh)
{
    validate(mesh);
    rebuildFaces(mesh);
    for (const VertexId v : liveVertices(mesh))
        for (const VertexId u : mesh.ring(v))
            EXPECT_EQ(canCollapse(mesh, v, u), vcgAcceptsCollapse(mesh, v, u))
                << "edge " << v << " " << u;
}

TEST(RingTopology, a_tetrahedron_points_outwards_and_is_closed)
{
    NeuralMesh mesh;
    makeTetrahedron(mesh, {1, 2, 3}, 2);
    validate(mesh);
    // Edge 2 r sqrt(2/3), volume edge^3 / (6 sqrt 2) = r^3 8 sqrt(3) / 27.
    EXPECT_NEAR(signedVolume(mesh), 8 * 8 * std::sqrt(3.0) / 27, 1e-12);
}

TEST(RingTopology, can_collapse_refuses_every_edge_of_a_tetrahedron)
{
    NeuralMesh mesh;
    makeTetrahedron(mesh, {0, 0, 0}, 1);
    for (const VertexId v : liveVertices(mesh))
        for (const VertexId u : mesh.ring(v))
            EXPECT_FALSE(canCollapse(mesh, v, u));
    compareCollapsesWithVcg(mesh);
}

TEST(RingTopology, can_collapse_leaves_each_component_a_tetrahedron)
{
    NeuralMesh mesh;
    test::makeMesh(mesh,
                   {{1, 1, 1},
                    {1, -1, -1},
                    {-1, 1, -1},
                    {-1, -1, 1},
                    {9, 1, 1},
                    {9, -1, -1},
                    {7, 1, -1},
                    {7, -1, 1}},
                   {{{0, 1, 2}},
                    {{0, 3, 1}},
                    {{0, 2, 3}},
                    {{1, 3, 2}},
                    {{4, 5, 6}},
                    {{4, 7, 5}},
                    {{4, 6, 7}},
                    {{5, 7, 6}}});
    for (const VertexId v : liveVertices(mesh))
        for (const VertexId u : mesh.ring(v))
            EXPECT_FALSE(canCollapse(mesh, v, u));
    compareCollapsesWithVcg(mesh);
}

TEST(RingTopology, can_collapse_agrees_with_vcg_on_small_meshes)
{
    NeuralMesh mesh;
    makeBipyramid(mesh);
    EXPECT_FALSE(canCollapse(mesh, 0, 1)); // 0 1 2 is a triangle but no face
    EXPECT_TRUE(canCollapse(mesh, 0, 3));
    compareCollapsesWithVcg(mesh);
    makeOctahedron(mesh);
    compareCollapsesWithVcg(mesh);
    makeTorus(mesh, 3, 3); // full of triangles around the tube that are no faces
    compareCollapsesWithVcg(mesh);
    makeTorus(mesh, 4, 5);
    compareCollapsesWithVcg(mesh);
}

TEST(RingTopology, can_collapse_agrees_with_vcg_on_open_meshes)
{
    NeuralMesh mesh;
    for (const VertexId size : {1U, 2U, 3U}) {
        makeSquare(mesh, size);
        compareCollapsesWithVcg(mesh);
    }
    makeTube(mesh, 3, 1); // full of triangles around it that are no faces
    compareCollapsesWithVcg(mesh);
    makeTube(mesh, 5, 2);
    compareCollapsesWithVcg(mesh);
    test::makeMesh(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}); // a single triangle
    compareCollapsesWithVcg(mesh);
    EXPECT_FALSE(canCollapse(mesh, 0, 1));
}

TEST(RingTopology, a_split_gives_both_vertices_the_promised_valences)
{
    NeuralMesh mesh;
    makeOctahedron(mesh);
    const VertexId w = mesh.addVertex({2, 0, 0});
    split(mesh, 0, 1, 3, w); // half of the star of a vertex of valence 4
    validate(mesh);
    EXPECT_EQ(mesh.valence(w), 4);
    EXPECT_EQ(mesh.valence(0), 4);
    EXPECT_EQ(measureTopology(mesh).genus, 0);
}

TEST(RingTopology, a_collapse_undoes_a_split)
{
    NeuralMesh mesh;
    makeTorus(mesh, 4, 4);
    std::vector<std::set<VertexId>> before;
    for (VertexId v = 0; v < 16; ++v)
        before.emplace_back(mesh.ring(v).begin(), mesh.ring(v).end());
    const VertexId w = mesh.addVertex({0, 0, 0});
    split(mesh, 5, 4, 1, w); // across the ring's first place
    validate(mesh);
    ASSERT_TRUE(canCollapse(mesh, w, 5));
    collapse(mesh, w, 5);
    validate(mesh);
    for (VertexId v = 0; v < 16; ++v)
        EXPECT_EQ(std::set<VertexId>(mesh.ring(v).begin(), mesh.ring(v).end()), before[v]);
    EXPECT_EQ(mesh.addVertex({0, 0, 0}), w); // the slot is used again
}

TEST(RingTopology, a_split_along_the_boundary_makes_a_neighbour_on_it)
{
    // The last vertex of the lower side, and what it keeps and gives:
    //
    //     6---7---8
    //     | / | / |
    //     3---4---5
    //     | / | / |
    //     0---1---2
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    ASSERT_EQ(std::vector<VertexId>(mesh.ring(1).begin(), mesh.ring(1).end()),
              (std::vector<VertexId>{2, 5, 4, 0}));
    const VertexId after = mesh.addVertex({1.5, 0, 0});
    split(mesh, 1, gapPlace, 1, after); // takes 2 and 5, and shares 5
    validate(mesh);
    EXPECT_EQ(nextOnBoundary(mesh, 1), after);
    EXPECT_EQ(nextOnBoundary(mesh, after), 2U);
    EXPECT_EQ(mesh.valence(after), 3);
    EXPECT_EQ(mesh.valence(1), 4);

    const VertexId before = mesh.addVertex({0.5, 0, 0});
    split(mesh, 1, 2, gapPlace, before); // takes 4 and 0, and shares 4
    validate(mesh);
    EXPECT_EQ(previousOnBoundary(mesh, 1), before);
    EXPECT_EQ(previousOnBoundary(mesh, before), 0U);
    EXPECT_EQ(mesh.valence(before), 3);
    EXPECT_EQ(mesh.valence(1), 4);
    EXPECT_EQ(boundaryLoops(mesh).front().size(), 10U);

    ASSERT_TRUE(canCollapse(mesh, after, 1));
    collapse(mesh, after, 1);
    ASSERT_TRUE(canCollapse(mesh, before, 1));
    collapse(mesh, before, 1);
    validate(mesh);
    EXPECT_EQ(std::vector<VertexId>(mesh.ring(1).begin(), mesh.ring(1).end()),
              (std::vector<VertexId>{2, 5, 4, 0}));
}

TEST(RingTopology, a_boundary_vertex_that_is_split_into_the_surface_stays_on_the_boundary)
{
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    const VertexId w = mesh.addVertex({1, 0.5, 0});
    split(mesh, 1, 1, 3, w); // takes 5, 4 and 0
    validate(mesh);
    EXPECT_FALSE(mesh.isOnBoundary(w));
    EXPECT_EQ(mesh.valence(w), 4);
    EXPECT_EQ(std::vector<VertexId>(mesh.ring(1).begin(), mesh.ring(1).end()),
              (std::vector<VertexId>{2, 5, w, 0}));
}

TEST(RingTopology, a_collapse_into_the_surface_takes_the_boundary_with_it)
{
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    ASSERT_TRUE(canCollapse(mesh, 1, 4));
    collapse(mesh, 1, 4);
    validate(mesh);
    EXPECT_TRUE(mesh.isOnBoundary(4));
    EXPECT_EQ(nextOnBoundary(mesh, 4), 2U);
    EXPECT_EQ(previousOnBoundary(mesh, 4), 0U);
}

TEST(RingTopology, an_edge_between_two_boundary_vertices_may_collapse_only_along_the_boundary)
{
    NeuralMesh mesh;
    makeSquare(mesh, 1);
    EXPECT_FALSE(canCollapse(mesh, 0, 3)); // the diagonal: nothing would be left
    EXPECT_TRUE(canCollapse(mesh, 0, 1));
    makeTube(mesh, 5, 1);
    EXPECT_FALSE(canCollapse(mesh, 0, 5)); // from end to end of the tube: both would meet
    EXPECT_TRUE(canCollapse(mesh, 0, 1));
}

TEST(RingTopology, an_edge_of_the_boundary_does_not_flip)
{
    NeuralMesh mesh;
    makeSquare(mesh, 1);
    EXPECT_FALSE(canFlip(mesh, 0, 1));
    ASSERT_TRUE(canFlip(mesh, 0, 3)); // the diagonal, though both ends keep two neighbours only
    flip(mesh, 0, 3);
    validate(mesh);
    EXPECT_TRUE(mesh.ring(1).contains(2));
}

TEST(RingTopology, a_flip_turns_the_edge_and_flipping_again_turns_it_back)
{
    NeuralMesh mesh;
    makeTorus(mesh, 5, 5);
    const VertexId u = mesh.ring(7)[2];
    const OppositeVertices opposite = oppositeVertices(mesh, 7, u);
    ASSERT_TRUE(canFlip(mesh, 7, u));
    flip(mesh, 7, u);
    validate(mesh);
    EXPECT_FALSE(mesh.ring(7).contains(u));
    EXPECT_TRUE(mesh.ring(opposite.left).contains(opposite.right));
    ASSERT_TRUE(canFlip(mesh, opposite.left, opposite.right));
    flip(mesh, opposite.left, opposite.right);
    validate(mesh);
    EXPECT_TRUE(mesh.ring(7).contains(u));
}

TEST(RingTopology, can_flip_refuses_what_would_double_an_edge_or_leave_two_neighbours)
{
    NeuralMesh mesh;
    makeBipyramid(mesh);
    EXPECT_FALSE(canFlip(mesh, 0, 3)); // vertex 3 has valence 3
    EXPECT_TRUE(canFlip(mesh, 0, 1));  // becomes 3-4
    flip(mesh, 0, 1);
    validate(mesh);
    EXPECT_FALSE(canFlip(mesh, 0, 2)); // vertex 0 has lost a neighbour: valence 3
    makeOctahedron(mesh);
    EXPECT_TRUE(canFlip(mesh, 0, 2)); // becomes 4-5
    flip(mesh, 0, 2);
    validate(mesh);
    EXPECT_FALSE(canFlip(mesh, 1, 3)); // 4 and 5 are neighbours already
    makeTetrahedron(mesh, {0, 0, 0}, 1);
    EXPECT_FALSE(canFlip(mesh, 0, 1));
}

TEST(RingTopology, faces_are_those_of_the_rings)
{
    NeuralMesh mesh;
    makeTorus(mesh, 4, 5);
    rebuildFaces(mesh);
    EXPECT_EQ(mesh.fn, 40);
    vcg::tri::UpdateTopology<NeuralMesh>::FaceFace(mesh);
    EXPECT_TRUE(vcg::tri::Clean<NeuralMesh>::IsWaterTight(mesh));
    EXPECT_TRUE(vcg::tri::Clean<NeuralMesh>::IsCoherentlyOrientedMesh(mesh));
}

TEST(RingTopology, turning_round_changes_the_sign_of_the_volume)
{
    NeuralMesh mesh;
    makeTorus(mesh, 8, 8);
    const double volume = signedVolume(mesh);
    EXPECT_GT(volume, 0);
    reverseOrientation(mesh);
    validate(mesh);
    EXPECT_DOUBLE_EQ(signedVolume(mesh), -volume);
}

/// A random split of v, from a random place on.
void splitAtRandom(NeuralMesh &mesh, VertexId v, Random &random)
{
    const NeighbourRing &ring = mesh.ring(v);
    const auto below = [&](int count) {
        return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
    };
    int first = below(ring.size());
    int last = (first + 1 + below(ring.size() - 1)) % ring.size();
    if (ring.isOpen()) {
        if (last < first)
            std::swap(first, last);
        if (below(3) == 0)
            first = gapPlace;
        else if (below(2) == 0)
            last = gapPlace;
    }
    split(mesh, v, first, last, mesh.addVertex(mesh.position(v)));
}

/// A random operation on a random edge, where it is allowed.
void mutate(NeuralMesh &mesh, Random &random, int most)
{
    const std::vector<VertexId> live = liveVertices(mesh);
    const VertexId v = live[random.below(live.size())];
    const VertexId u =
        mesh.ring(v)[static_cast<int>(random.below(static_cast<std::uint64_t>(mesh.valence(v))))];
    switch (random.below(3)) {
    case 0:
        if (canCollapse(mesh, v, u))
            collapse(mesh, v, u);
        return;
    case 1:
        if (canFlip(mesh, v, u))
            flip(mesh, v, u);
        return;
    default:
        if (mesh.vn < most)
            splitAtRandom(mesh, v, random);
    }
}

void mutateAndValidate(NeuralMesh &mesh, std::uint64_t seed, int operations, int most)
{
    const TopologyFigures before = measureTopology(mesh);
    Random random(seed);
    for (int i = 0; i < operations; ++i) {
        mutate(mesh, random, most);
        ASSERT_NO_THROW(validate(mesh)) << "seed " << seed << ", operation " << i;
        const TopologyFigures now = measureTopology(mesh);
        ASSERT_EQ(now.genus, before.genus);
        ASSERT_EQ(now.components, before.components);
        ASSERT_EQ(now.boundaryLoops, before.boundaryLoops);
    }
}

TEST(RingTopology, random_operations_keep_a_sphere_a_sphere)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        NeuralMesh mesh;
        makeTetrahedron(mesh, {0, 0, 0}, 1);
        mutateAndValidate(mesh, seed, 25000, 24); // small: every refusal is met often
    }
    NeuralMesh mesh;
    makeOctahedron(mesh);
    mutateAndValidate(mesh, 4, 15000, 60);
}

TEST(RingTopology, random_operations_keep_a_torus_a_torus)
{
    for (const std::uint64_t seed : {5U, 6U}) {
        NeuralMesh mesh;
        makeTorus(mesh, 4, 4);
        mutateAndValidate(mesh, seed, 15000, 40);
    }
}

TEST(RingTopology, random_operations_keep_open_meshes_as_open_as_they_are)
{
    for (const std::uint64_t seed : {7U, 8U, 9U}) {
        NeuralMesh mesh;
        makeSquare(mesh, 1);
        mutateAndValidate(mesh, seed, 15000, 20);
        makeTube(mesh, 4, 1);
        mutateAndValidate(mesh, seed, 10000, 24);
        makeTorus(mesh, 5, 5);
        openDisc(mesh, {0, 5, 6, 1}, {});
        openDisc(mesh, {12, 17, 18, 13}, {});
        mutateAndValidate(mesh, seed, 10000, 40);
    }
}

TEST(RingTopology, can_collapse_agrees_with_vcg_on_open_meshes_after_random_operations)
{
    NeuralMesh mesh;
    makeSquare(mesh, 2);
    Random random(11);
    for (int i = 0; i < 400; ++i) {
        mutate(mesh, random, 16);
        NeuralMesh compact;
        compact.copyNetwork(mesh);
        compareCollapsesWithVcg(compact);
    }
}

} // namespace
} // namespace neuralmesh
