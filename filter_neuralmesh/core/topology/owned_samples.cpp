// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/owned_samples.h"

#include <algorithm>

#include "core/network/star_projection.h"
#include "core/space/vertices_of.h"

namespace neuralmesh {
OwnedSamples::OwnedSamples(const NeuralMesh &mesh, const FaceTable &faces,
                           const SampleSupport &support)
    : mesh_(mesh), faces_(faces), support_(support), nearest_(support.samples().size(), noVertex)
{
}

double OwnedSamples::perFace() const
{
    return static_cast<double>(support_.samples().size()) / faces_.size();
}

std::vector<SampleId> OwnedSamples::of(const Patch &patch, const PatchSearch &patches)
{
    Box3 box;
    for (const std::vector<VertexId> *vertices : {&patch.rim, &patch.interior})
        for (const VertexId v : *vertices)
            box.Add(mesh_.position(v));
    std::vector<SampleId> found;
    support_.forEachWithin(box.Center(), box.Diag() / 2, [&](SampleId sample) {
        if (isOwned(sample, patches))
            found.push_back(sample);
    });
    std::sort(found.begin(), found.end());
    return found;
}

VertexId OwnedSamples::nearestVertex(SampleId sample)
{
    if (!vertices_)
        vertices_.emplace(verticesOf(mesh_, support_.bounds()));
    if (nearest_[sample] == noVertex)
        nearest_[sample] = vertices_->nearest(support_.samples()[sample]);
    return nearest_[sample];
}

/// Whether the nearest point of the mesh lies on a face of the patch. On an edge or a corner it is
/// of all faces there.
bool OwnedSamples::isOwned(SampleId sample, const PatchSearch &patches)
{
    const StarProjection p =
        projectOnStar(mesh_, nearestVertex(sample), support_.samples()[sample]);
    VertexId at[3];
    VertexId *end = at;
    for (int k = 0; k < 3; ++k)
        if (p.weights[k] > 0)
            *end++ = p.corners[k];
    for (int i = 0; i < mesh_.valence(at[0]); ++i) {
        const FaceId face = faces_.around(at[0], i);
        const Corners &corners = faces_.corners(face);
        const auto isCorner = [&](VertexId v) {
            return std::find(corners.begin(), corners.end(), v) != corners.end();
        };
        if (patches.contains(face) && std::all_of(at, end, isCorner))
            return true;
    }
    return false;
}

} // namespace neuralmesh
