// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/unsupported_patches.h"

#include <algorithm>
#include <cstddef>

#include "core/mesh/edge_lengths.h"
#include "core/mesh/enumeration.h"
#include "core/topology/refused_patches.h"

namespace neuralmesh {
namespace {

/// Distance of an edge's middle from all samples, in lengths of the edge, from which the edge is
/// far. On a surface, the height of the arc over an edge is far less; across a gap the distance is
/// up to half the edge.
constexpr Scalar farDistance = 0.35;

/// Supported islands in a patch are filled up to this size: a few faces, and half the patch.
constexpr std::size_t smallIsland = 10;

/// Some milliseconds.
constexpr VertexId verticesPerLook = 1024;

} // namespace

PatchSearch::PatchSearch(const NeuralMesh &mesh, const FaceTable &faces,
                         const SampleSupport &support, const RefusedPatches &refused)
    : mesh_(mesh), faces_(faces), isFar_(3 * static_cast<std::size_t>(faces.size()), 0),
      isSeed_(faces.size(), 0), patchOf_(faces.size(), none), seenBy_(faces.size(), 0)
{
    judgeEdges(support, refused);
}

void PatchSearch::judgeEdges(const SampleSupport &support, const RefusedPatches &refused)
{
    forEachEdge(mesh_, [&](VertexId a, VertexId b) {
        if (a % verticesPerLook == 0)
            support.watch().look();
        const Point3 middle = (mesh_.position(a) + mesh_.position(b)) / 2;
        if (support.hasWithin(middle, farDistance * edgeLength(mesh_, a, b)))
            return;
        const bool isSeed = !refused.holds(a, b);
        markFar(a, b, isSeed);
        markFar(b, a, isSeed);
    });
}

/// The edge from a to b, of the face to its left.
void PatchSearch::markFar(VertexId a, VertexId b, bool isSeed)
{
    const FaceId face = faces_.leftOf(a, b);
    const Corners &corners = faces_.corners(face);
    const auto start = std::find(corners.begin(), corners.end(), a) - corners.begin();
    isFar_[std::size_t(3) * face + static_cast<std::size_t>(start)] = 1;
    if (isSeed)
        isSeed_[face] = 1;
}

std::optional<Patch> PatchSearch::find(FaceId seed, PatchExtent extent)
{
    ++patch_;
    std::vector<FaceId> patch{seed};
    patchOf_[seed] = patch_;
    spread(patch, 0);
    for (const FaceId face : patch)
        isSeed_[face] = 0;
    if (extent == PatchExtent::dilated)
        dilate(patch);
    if (fillIslands(patch))
        if (std::optional<Patch> found = outline(patch))
            return found;
    forget(patch);
    return std::nullopt;
}

void PatchSearch::release(const Patch &patch)
{
    forget(patch.faces);
}

void PatchSearch::forget(const std::vector<FaceId> &patch)
{
    for (const FaceId face : patch)
        patchOf_[face] = none;
}

/// Whether the face is in the patch now: it may belong to another.
bool PatchSearch::add(FaceId face, std::vector<FaceId> &patch)
{
    if (patchOf_[face] == none) {
        patchOf_[face] = patch_;
        patch.push_back(face);
    }
    return patchOf_[face] == patch_;
}

/// Across far edges of the patch's faces, from the face at place `from` on.
void PatchSearch::spread(std::vector<FaceId> &patch, std::size_t from)
{
    for (std::size_t i = from; i < patch.size(); ++i) {
        const Corners corners = faces_.corners(patch[i]);
        for (std::size_t k = 0; k < 3; ++k)
            if (isFar_[std::size_t(3) * patch[i] + k] != 0)
                add(faces_.leftOf(corners[(k + 1) % 3], corners[k]), patch);
    }
}

/// One row of faces more, and what these spread to.
void PatchSearch::dilate(std::vector<FaceId> &patch)
{
    const std::size_t before = patch.size();
    for (std::size_t i = 0; i < before; ++i)
        for (const VertexId v : faces_.corners(patch[i]))
            for (int place = 0; place < mesh_.valence(v); ++place)
                add(faces_.around(v, place), patch);
    spread(patch, before);
}

/// Adds small parts of the surface that the patch encloses. False where faces of another patch are
/// in the way.
bool PatchSearch::fillIslands(std::vector<FaceId> &patch)
{
    const int searchesBefore = island_;
    const std::size_t size = patch.size();
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const Corners &corners = faces_.corners(patch[i]);
            const FaceId behind = faces_.leftOf(corners[(k + 1) % 3], corners[k]);
            if (patchOf_[behind] == patch_ || seenBy_[behind] > searchesBefore)
                continue;
            for (const FaceId face : islandBehind(behind, smallIsland + size / 2, searchesBefore)) {
                if (!add(face, patch))
                    return false;
            }
        }
    return true;
}

/// The faces reached without entering the patch; none where there are more than `most`, or where
/// an earlier search since `searchesBefore` was here: it gave up, or its faces were in the patch.
std::vector<FaceId> PatchSearch::islandBehind(FaceId face, std::size_t most, int searchesBefore)
{
    ++island_;
    std::vector<FaceId> island{face};
    seenBy_[face] = island_;
    for (std::size_t i = 0; i < island.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const Corners &corners = faces_.corners(island[i]);
            const FaceId next = faces_.leftOf(corners[(k + 1) % 3], corners[k]);
            if (patchOf_[next] == patch_ || seenBy_[next] == island_)
                continue;
            if (island.size() == most || seenBy_[next] > searchesBefore)
                return {};
            seenBy_[next] = island_;
            island.push_back(next);
        }
    return island;
}

int PatchSearch::rimEdgesFrom(VertexId v, VertexId &next) const
{
    int count = 0;
    for (const VertexId u : mesh_.ring(v))
        if (isInside(v, u) && !isInside(u, v)) {
            next = u;
            ++count;
        }
    return count;
}

/// None where the patch is no disc with a simple loop around it.
std::optional<Patch> PatchSearch::outline(std::vector<FaceId> patch) const
{
    Patch found;
    std::vector<VertexId> vertices;
    std::size_t rimEdges = 0;
    VertexId start = noVertex;
    for (const FaceId face : patch)
        for (std::size_t k = 0; k < 3; ++k) {
            const Corners &corners = faces_.corners(face);
            vertices.push_back(corners[k]);
            if (!isInside(corners[(k + 1) % 3], corners[k])) {
                ++rimEdges;
                start = corners[k];
            }
        }
    if (start == noVertex)
        return std::nullopt;
    VertexId at = start;
    do {
        found.rim.push_back(at);
        VertexId next = noVertex;
        if (found.rim.size() > rimEdges || rimEdgesFrom(at, next) != 1)
            return std::nullopt;
        at = next;
    } while (at != start);

    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<VertexId> onRim = found.rim;
    std::sort(onRim.begin(), onRim.end());
    std::set_difference(vertices.begin(), vertices.end(), onRim.begin(), onRim.end(),
                        std::back_inserter(found.interior));
    const std::size_t edges = (3 * patch.size() + rimEdges) / 2;
    const bool isDisc =
        found.rim.size() == rimEdges && vertices.size() + patch.size() == edges + 1; // Euler
    if (!isDisc)
        return std::nullopt;
    found.faces = std::move(patch);
    return found;
}

} // namespace neuralmesh
