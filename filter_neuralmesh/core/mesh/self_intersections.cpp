// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/self_intersections.h"

#include <algorithm>
#include <utility>

#include <vcg/complex/algorithms/clean.h>

#include "core/mesh/ring_topology.h"
#include "core/space/box_tree.h"

namespace neuralmesh {
namespace {

/// Faces that a thread tests at a time.
constexpr std::size_t facesOfChunk = 512;

Box3 boundsOf(const NeuralFace &face)
{
    Box3 bounds;
    face.GetBBox(bounds);
    return bounds;
}

/// Faces after this one that intersect it, and then this one.
void addPartners(NeuralMesh &mesh, NeuralFace &face, const BoxTree &boxes,
                 std::vector<NeuralFace *> &found)
{
    const std::size_t before = found.size();
    boxes.forEachMeeting(boundsOf(face), [&](std::uint32_t i) {
        NeuralFace *other = &mesh.face[i];
        if (other > &face && vcg::tri::Clean<NeuralMesh>::TestFaceFaceIntersection(&face, other))
            found.push_back(other);
    });
    if (found.size() > before)
        found.push_back(&face);
}

} // namespace

SelfIntersections findSelfIntersections(NeuralMesh &mesh, Workers &workers)
{
    rebuildFaces(mesh);
    std::vector<Box3> bounds;
    bounds.reserve(mesh.face.size());
    for (const NeuralFace &face : mesh.face)
        bounds.push_back(boundsOf(face));
    const BoxTree boxes(std::move(bounds));
    std::vector<std::vector<NeuralFace *>> ofChunks(mesh.face.size() / facesOfChunk + 1);
    workers.forEachChunk(
        mesh.face.size(), facesOfChunk, [&](std::size_t first, std::size_t end, int) {
            for (std::size_t i = first; i < end; ++i)
                addPartners(mesh, mesh.face[i], boxes, ofChunks[first / facesOfChunk]);
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
