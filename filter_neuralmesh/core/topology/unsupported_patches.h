// SPDX-License-Identifier: GPL-3.0-or-later
// Patches of faces that span a void: no sample lies where they are.
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/face_table.h"
#include "core/topology/sample_support.h"

namespace neuralmesh {

class RefusedPatches;

/// Faces that make a disc.
struct Patch {
    std::vector<FaceId> faces;
    std::vector<VertexId> rim;      ///< the closed loop around it, faces to its left
    std::vector<VertexId> interior; ///< its other vertices
};

/// How far a patch spreads: across edges that are far from all samples; or one row of faces
/// further.
enum class PatchExtent { core, dilated };

/// Finds patches around edges that are far from all samples. A mark of one's own is kept on every
/// face, so each search is made for one mesh and forgotten.
class PatchSearch {
public:
    /// No patch starts where one was refused before and the mesh has not moved since.
    PatchSearch(const NeuralMesh &mesh, const FaceTable &faces, const SampleSupport &support,
                const RefusedPatches &refused);

    /// Whether an edge of the face is so far from all samples that a patch may start here. False
    /// for faces of patches found before, and where a search has spread to from another seed: it
    /// would find the same.
    bool isSeed(FaceId face) const { return isSeed_[face] && patchOf_[face] == none; }

    /// The disc of faces around a face that is a seed, or was before it was searched from. None
    /// where that is no disc. Faces of a patch belong to it until it is released.
    std::optional<Patch> find(FaceId seed, PatchExtent extent);
    void release(const Patch &patch);

    /// Whether the face is in the patch found last.
    bool contains(FaceId face) const { return patchOf_[face] == patch_; }
    /// Whether both faces at edge (a, b) are.
    bool isInterior(VertexId a, VertexId b) const { return isInside(a, b) && isInside(b, a); }

private:
    static constexpr int none = -1;

    void judgeEdges(const SampleSupport &support, const RefusedPatches &refused);
    void markFar(VertexId a, VertexId b, bool isSeed);
    void spread(std::vector<FaceId> &patch, std::size_t from);
    void dilate(std::vector<FaceId> &patch);
    bool fillIslands(std::vector<FaceId> &patch);
    std::vector<FaceId> islandBehind(FaceId face, std::size_t most, int searchesBefore);
    bool add(FaceId face, std::vector<FaceId> &patch);
    bool isInside(VertexId a, VertexId b) const { return contains(faces_.leftOf(a, b)); }
    /// How often the rim leaves v; the next vertex of the rim, if any, goes into `next`.
    int rimEdgesFrom(VertexId v, VertexId &next) const;
    std::optional<Patch> outline(std::vector<FaceId> patch) const;
    void forget(const std::vector<FaceId> &patch);

    const NeuralMesh &mesh_;
    const FaceTable &faces_;
    std::vector<char> isFar_; ///< by face and corner k: its edge from corner k to the next
    std::vector<char> isSeed_;
    std::vector<int> patchOf_;
    std::vector<int> seenBy_; ///< by face: the last island search that met it
    int patch_ = none;
    int island_ = 0;
};

} // namespace neuralmesh
