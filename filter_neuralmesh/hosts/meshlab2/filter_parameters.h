// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where values of filters.json become parameters of the core.
#pragma once

#include <cstdint>

#include "hosts/common/host_terms.h"
#include "meshfilterplugin.h"
#include "neuralmesh/parameters.h"

namespace neuralmesh::meshlab2 {

/// What is sampled, in the order of the options of "source".
enum class Source { points, surface, visibleLayers, pointFile };

/// Not validated yet; maxHoleSize is a share of the diagonal. The host has resolved the seed.
/// Throws InvalidInput for snapshots that are no counts, and for an option that there is not.
GrowthParameters growthParameters(const MeshFilterParameterValues &values, std::uint64_t seed);

/// Throws InvalidInput for an option that there is not.
Source sourceOf(const MeshFilterParameterValues &values);

/// Parameters are called by their ids, which scripts type.
const HostTerms &terms();

} // namespace neuralmesh::meshlab2
