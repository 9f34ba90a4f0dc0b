// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/self_intersections.h"

#include <algorithm>
#include <utility>

#include <vcg/complex/algorithms/clean.h>
#include <vcg/space/index/grid_static_ptr.h>

#include "core/mesh/ring_topology.h"

namespace neuralmesh {
namespace {

/// Faces that a thread tests at a time.
constexpr std::size_t facesOfChunk = 512;

using FaceGrid = vcg::GridStaticPtr<NeuralFace, Scalar>;

/// What the grid asks so as to find a face once: threads share no marks, so it finds it once for
/// each cell.
struct NoMarks {
    void UnMarkAll() {}
    bool IsMarked(const NeuralFace *) const { return false; }
    void Mark(const NeuralFace *) {}
};

/// Faces after this one that intersect it, and then this one.
void addPartners(NeuralFace &face, FaceGrid &grid, std::vector<NeuralFace *> &found)
{
    Box3 bounds;
    face.GetBBox(bounds);
    std::vector<NeuralFace *> near;
    NoMarks marks;
    grid.GetInBox(marks, bounds, near);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    const std::size_t before = found.size();
    for (NeuralFace *other : near)
        if (other > &face && vcg::tri::Clean<NeuralMesh>::TestFaceFaceIntersection(&face, other))
            found.push_back(other);
    if (found.size() > before)
        found.push_back(&face);
}

} // namespace

SelfIntersections findSelfIntersections(NeuralMesh &mesh, Workers &workers)
{
    rebuildFaces(mesh);
    FaceGrid grid;
    grid.Set(mesh.face.begin(), mesh.face.end());
    std::vector<std::vector<NeuralFace *>> ofChunks(mesh.face.size() / facesOfChunk + 1);
    workers.forEachChunk(mesh.face.size(), facesOfChunk,
                         [&](std::size_t first, std::size_t end, int) {
                             for (std::size_t i = first; i < end; ++i)
                                 addPartners(mesh.face[i], grid, ofChunks[first / facesOfChunk]);
                         });
    SelfIntersections found;
    std::vector<VertexId> &corners = found.corners;
    for (const std::vector<NeuralFace *> &faces : ofChunks) {
        found.faces += static_cast<int>(faces.size());
        for (const NeuralFace *face : faces)
            for (int corner = 0; corner < 3; ++corner)
                corners.push_back(static_cast<VertexId>(vcg::tri::Index(mesh, face->cV(corner))));
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return found;
}

SelfIntersections findSelfIntersections(NeuralMesh &mesh)
{
    Workers alone;
    return findSelfIntersections(mesh, alone);
}

} // namespace neuralmesh
