// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/refused_patches.h"

#include <limits>

#include "core/mesh/edge_lengths.h"

namespace neuralmesh {
namespace {

/// A vertex has moved that is so far from where it was, in lengths of its edge. Samples pull
/// vertices to and fro by less.
constexpr Scalar farFromPlace = 0.25;

constexpr Scalar nowhere = std::numeric_limits<Scalar>::infinity();

} // namespace

RefusedPatches::RefusedPatches(const NeuralMesh &mesh)
    : mesh_(mesh), places_(mesh, {nowhere, nowhere, nowhere})
{
}

void RefusedPatches::add(const Patch &patch)
{
    for (const std::vector<VertexId> *vertices : {&patch.rim, &patch.interior})
        for (const VertexId v : *vertices)
            places_[v] = mesh_.position(v);
}

bool RefusedPatches::holds(VertexId a, VertexId b) const
{
    const Scalar reach = farFromPlace * edgeLength(mesh_, a, b);
    const auto stays = [&](VertexId v) {
        return (mesh_.position(v) - places_[v]).SquaredNorm() <= reach * reach;
    };
    return stays(a) && stays(b);
}

} // namespace neuralmesh
