// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on rings as a program of bytes: a mesh to begin with, then four bytes an operation.
// After each, the mesh has to be an oriented two-manifold with the figures that follow from it.
#include <algorithm>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
#include "fuzz/choices.h"
#include "fuzz/fuzz_target.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh::fuzz {
namespace {

constexpr int mostVertices = 60;

void makeMesh(NeuralMesh &mesh, int which)
{
    switch (which) {
    case 0: return makeTetrahedron(mesh, {0, 0, 0}, 1);
    case 1: return test::makeBipyramid(mesh);
    case 2: return test::makeTorus(mesh, 3, 3);
    case 3: return test::makeTorus(mesh, 4, 5);
    case 4: return test::makeSquare(mesh, 1);
    case 5: return test::makeSquare(mesh, 2);
    case 6: return test::makeTube(mesh, 3, 1);
    default: return test::makeTube(mesh, 5, 2);
    }
}

/// An operation and the figures that it has to leave.
class Operation {
public:
    Operation(NeuralMesh &mesh, Choices &choices)
        : mesh_(mesh), choices_(choices), expected_(measureTopology(mesh))
    {
        std::vector<VertexId> live;
        forEachVertex(mesh, [&](VertexId v) { live.push_back(v); });
        v_ = live[static_cast<std::size_t>(choices.below(static_cast<int>(live.size())))];
        u_ = mesh.ring(v_)[choices.below(mesh.valence(v_))];
    }

    void run(int which)
    {
        switch (which) {
        case 0: return collapseEdge();
        case 1: return flipEdge();
        case 2: return splitVertex();
        case 3: return coverBoundary();
        case 4: return openStar();
        case 5: return refillStar();
        case 6: return fillHole();
        default: return reverseOrientation(mesh_);
        }
    }

    void check() const
    {
        validate(mesh_);
        const TopologyFigures now = measureTopology(mesh_);
        require(now.vertices == expected_.vertices, "the number of vertices");
        require(now.faces == expected_.faces, "the number of faces");
        require(now.components == expected_.components, "the number of components");
        require(isMoreFlexible_ || now.genus == expected_.genus, "the genus");
        require(isMoreFlexible_ || now.boundaryLoops == expected_.boundaryLoops, "the boundaries");
    }

private:
    void collapseEdge()
    {
        if (!canCollapse(mesh_, v_, u_))
            return;
        const bool isOnBoundary = isBoundaryEdge(mesh_, v_, u_);
        collapse(mesh_, v_, u_);
        --expected_.vertices;
        expected_.faces -= isOnBoundary ? 1 : 2;
    }

    void flipEdge()
    {
        if (canFlip(mesh_, v_, u_))
            flip(mesh_, v_, u_);
    }

    void splitVertex()
    {
        if (mesh_.vn >= mostVertices)
            return;
        const NeighbourRing &ring = mesh_.ring(v_);
        int first = ring.find(u_);
        int last = (first + 1 + choices_.below(ring.size() - 1)) % ring.size();
        bool isAlongBoundary = false;
        if (ring.isOpen()) {
            if (last < first)
                std::swap(first, last);
            const int end = choices_.below(3);
            if (end == 1)
                first = gapPlace;
            else if (end == 2)
                last = gapPlace;
            isAlongBoundary = end > 0;
        }
        split(mesh_, v_, first, last, mesh_.addVertex(mesh_.position(v_)));
        ++expected_.vertices;
        expected_.faces += isAlongBoundary ? 1 : 2;
    }

    /// A boundary may come to be two, and a handle may come of two boundaries.
    void coverBoundary()
    {
        if (!canCloseOver(mesh_, v_))
            return;
        closeOver(mesh_, v_);
        ++expected_.faces;
        isMoreFlexible_ = true;
    }

    std::vector<VertexId> star() const { return {mesh_.ring(v_).begin(), mesh_.ring(v_).end()}; }

    /// A fan of the loop from its first corner; none where a diagonal is an edge already.
    std::vector<LoopTriangle> fanOf(const std::vector<VertexId> &loop) const
    {
        std::vector<LoopTriangle> triangles;
        for (std::size_t i = 2; i < loop.size(); ++i) {
            if (i + 1 < loop.size() && mesh_.ring(loop[0]).contains(loop[i]))
                return {};
            triangles.push_back({0, static_cast<int>(i) - 1, static_cast<int>(i)});
        }
        return triangles;
    }

    void openStar()
    {
        const std::vector<VertexId> rim = star();
        if (mesh_.isOnBoundary(v_) || !canOpenDisc(mesh_, rim))
            return;
        openDisc(mesh_, rim, {v_});
        --expected_.vertices;
        expected_.faces -= static_cast<int>(rim.size());
        ++expected_.boundaryLoops;
    }

    void refillStar()
    {
        const std::vector<VertexId> rim = star();
        const std::vector<LoopTriangle> triangles = fanOf(rim);
        // Three vertices on both sides of one triangle are no mesh.
        if (mesh_.isOnBoundary(v_) || triangles.empty() ||
            (rim.size() == 3 && !canCollapse(mesh_, v_, u_)))
            return;
        refillDisc(mesh_, rim, {v_}, triangles);
        --expected_.vertices;
        expected_.faces -= 2;
    }

    void fillHole()
    {
        std::vector<std::vector<VertexId>> loops = boundaryLoops(mesh_);
        if (loops.empty())
            return;
        std::vector<VertexId> &rim =
            loops[static_cast<std::size_t>(choices_.below(static_cast<int>(loops.size())))];
        std::reverse(rim.begin(), rim.end());
        const std::vector<LoopTriangle> triangles = fanOf(rim);
        // The boundary of a single triangle has no other side.
        if (triangles.empty() || rim.size() == static_cast<std::size_t>(mesh_.valence(rim[0])) + 1)
            return;
        refillDisc(mesh_, rim, {}, triangles);
        expected_.faces += static_cast<int>(rim.size()) - 2;
        --expected_.boundaryLoops;
    }

    NeuralMesh &mesh_;
    Choices &choices_;
    TopologyFigures expected_;
    VertexId v_ = 0, u_ = 0;
    bool isMoreFlexible_ = false;
};

} // namespace
} // namespace neuralmesh::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    using namespace neuralmesh;
    fuzz::Choices choices(data, size);
    NeuralMesh mesh;
    fuzz::makeMesh(mesh, choices.below(8));
    while (!choices.isEnd()) {
        const int which = choices.below(8);
        fuzz::Operation operation(mesh, choices);
        operation.run(which);
        operation.check();
    }
    return 0;
}
