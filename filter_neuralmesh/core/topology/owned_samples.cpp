// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/owned_samples.h"

#include <algorithm>

#include "core/network/star_projection.h"
#include "core/space/vertices_of.h"

namespace neuralmesh {
OwnedSamples::OwnedSamples(const NeuralMesh &mesh, const FaceTable &faces,
                           const SampleSupport &support)
    : mesh_(mesh), faces_(faces), support_(support), feet_(support.samples().size())
{
}

double OwnedSamples::perFace() const
{
    return static_cast<double>(support_.samples().size()) / faces_.size();
}

std::optional<Scalar> OwnedSamples::squaredDistance(SampleId sample, const PatchSearch &patches)
{
    const Foot &foot = footOf(sample);
    if (!isOnPatch(foot, patches))
        return std::nullopt;
    return foot.squaredDistance;
}

std::size_t OwnedSamples::count(const Patch &patch, const PatchSearch &patches)
{
    Box3 box;
    for (const std::vector<VertexId> *vertices : {&patch.rim, &patch.interior})
        for (const VertexId v : *vertices)
            box.Add(mesh_.position(v));
    std::size_t count = 0;
    support_.forEachWithin(box.Center(), box.Diag() / 2, [&](SampleId sample) {
        count += isOnPatch(footOf(sample), patches) ? 1 : 0;
    });
    return count;
}

const OwnedSamples::Foot &OwnedSamples::footOf(SampleId sample)
{
    Foot &foot = feet_[sample];
    if (foot.corners[0] != noVertex)
        return foot;
    if (!vertices_)
        vertices_.emplace(verticesOf(mesh_, support_.bounds()));
    const Point3 &position = support_.samples()[sample];
    const StarProjection p = projectOnStar(mesh_, vertices_->nearest(position), position);
    std::size_t corner = 0;
    for (int k = 0; k < 3; ++k)
        if (p.weights[k] > 0)
            foot.corners[corner++] = p.corners[k];
    foot.squaredDistance = p.squaredDistance;
    return foot;
}

/// A point on an edge or a corner is of all faces there.
bool OwnedSamples::isOnPatch(const Foot &foot, const PatchSearch &patches) const
{
    const auto end = std::find(foot.corners.begin(), foot.corners.end(), noVertex);
    for (int i = 0; i < mesh_.valence(foot.corners[0]); ++i) {
        const FaceId face = faces_.around(foot.corners[0], i);
        const Corners &corners = faces_.corners(face);
        const auto isCorner = [&](VertexId v) {
            return std::find(corners.begin(), corners.end(), v) != corners.end();
        };
        if (patches.contains(face) && std::all_of(foot.corners.begin(), end, isCorner))
            return true;
    }
    return false;
}

} // namespace neuralmesh
