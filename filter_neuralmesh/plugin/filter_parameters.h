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

/// MaxHoleSize in the unit frame of a target space, whose diagonal is given in the world. The host
/// turns percentages into lengths by the document's box, which is not that of the target space
/// where there are strays, more layers, or a point file. So the default, and a length that is
/// longer than the target space, are taken for the percentage that they are of that box.
double holeSizeInFrame(const RichParameterList &parameters, const MeshDocument &document,
                       double diagonal);
