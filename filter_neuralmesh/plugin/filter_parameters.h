// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where parameters of the core meet parameters of the host.
#pragma once

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>

#include "neuralmesh/parameters.h"

/// What each filter's dialog and scripts offer, with the core's defaults; for reconstruction,
/// TargetVertNum is at most half the points of the current layer. The document is also that of
/// which a starting layer can be chosen.
RichParameterList reconstructionParameters(const MeshDocument &document);
RichParameterList implicitParameters(const MeshDocument &document);
RichParameterList parametricParameters(const MeshDocument &document);

/// The core's parameters, not validated yet, maxHoleSize still in units of the input. A RandomSeed
/// of 0 becomes a fresh positive seed.
/// Throws InvalidInput for a negative RandomSeed and for Snapshots that are no list of counts.
neuralmesh::GrowthParameters readGrowthParameters(const RichParameterList &parameters);
