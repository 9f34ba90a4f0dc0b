// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/owned_samples.h"

#include <algorithm>
#include <limits>

#include "core/mesh/triangle.h"
#include "core/network/star_projection.h"

namespace neuralmesh {
namespace {

/// A sample at the rim of a patch is as near to the faces beside it, but for rounding.
constexpr Scalar rounding = 1e-6;

} // namespace

OwnedSamples::OwnedSamples(const NeuralMesh &mesh, const FaceTable &faces, const VertexGrid &grid,
                           const SampleSupport &support)
    : mesh_(mesh), faces_(faces), grid_(grid), support_(support),
      nearest_(support.samples().size(), noVertex)
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
    if (nearest_[sample] == noVertex)
        nearest_[sample] = grid_.nearest(support_.samples()[sample]);
    return nearest_[sample];
}

bool OwnedSamples::isOwned(SampleId sample, const PatchSearch &patches)
{
    const Point3 &place = support_.samples()[sample];
    const VertexId v = nearestVertex(sample);
    constexpr Scalar none = std::numeric_limits<Scalar>::max();
    Scalar toPatch = none;
    Scalar beside = none;
    for (int i = 0; i < mesh_.valence(v); ++i) {
        const FaceId face = faces_.around(v, i);
        const Corners &c = faces_.corners(face);
        const Triangle triangle{mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2])};
        Scalar &least = patches.contains(face) ? toPatch : beside;
        least = std::min(least, squaredDistanceTo(triangle, place));
    }
    return toPatch < none && toPatch <= (1 + rounding) * beside;
}

} // namespace neuralmesh
