// SPDX-License-Identifier: GPL-3.0-or-later
// Random operations on rings, and what VCG makes of a collapse.
#pragma once

#include <gtest/gtest.h>
#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/update/topology.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "neuralmesh/random.h"

namespace neuralmesh::test {

inline std::vector<VertexId> liveVertices(const NeuralMesh &mesh)
{
    std::vector<VertexId> live;
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        if (mesh.isLive(v))
            live.push_back(v);
    return live;
}

/// What has to stay the same of a mesh without non-manifold edges, as VCG counts it (it walks along
/// boundaries, which has no meaning at an edge of three faces).
struct VcgFigures {
    int euler, boundaries, components;

    explicit VcgFigures(NeuralMesh &mesh)
    {
        vcg::tri::UpdateTopology<NeuralMesh>::FaceFace(mesh);
        int edges = 0;
        int boundaryEdges = 0;
        int nonManifoldEdges = 0;
        vcg::tri::Clean<NeuralMesh>::CountEdgeNum(mesh, edges, boundaryEdges, nonManifoldEdges);
        euler = mesh.vn - edges + mesh.fn;
        boundaries = vcg::tri::Clean<NeuralMesh>::CountHoles(mesh);
        components = vcg::tri::Clean<NeuralMesh>::CountConnectedComponents(mesh);
    }
    bool operator==(const VcgFigures &other) const
    {
        return euler == other.euler && boundaries == other.boundaries &&
               components == other.components;
    }
};

/// Three faces or more at an edge. (VCG's count of such edges uses up its bits of a face.)
inline bool hasNonManifoldEdge(const NeuralMesh &mesh)
{
    return std::any_of(mesh.face.begin(), mesh.face.end(), [](const NeuralFace &face) {
        return !face.IsD() && !(vcg::face::IsManifold(face, 0) && vcg::face::IsManifold(face, 1) &&
                                vcg::face::IsManifold(face, 2));
    });
}

/// What VCG says of the mesh that plain index replacement leaves of edge (v, u): two-manifold, no
/// doubled or degenerate face, no vertex lost but v, topology kept.
inline bool vcgAcceptsCollapse(NeuralMesh &source, VertexId v, VertexId u)
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
    return mesh.vn == source.vn - 1 && !hasNonManifoldEdge(mesh) &&
           Clean::CountNonManifoldVertexFF(mesh) == 0 && VcgFigures(mesh) == VcgFigures(source);
}

inline void compareCollapsesWithVcg(NeuralMesh &mesh)
{
    validate(mesh);
    rebuildFaces(mesh);
    for (const VertexId v : liveVertices(mesh))
        for (const VertexId u : mesh.ring(v))
            EXPECT_EQ(canCollapse(mesh, v, u), vcgAcceptsCollapse(mesh, v, u))
                << "edge " << v << " " << u;
}

/// A random split of v, from a random place on.
inline void splitAtRandom(NeuralMesh &mesh, VertexId v, Random &random)
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
inline void mutate(NeuralMesh &mesh, Random &random, int most)
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

inline void mutateAndValidate(NeuralMesh &mesh, std::uint64_t seed, int operations, int most)
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

} // namespace neuralmesh::test
