// SPDX-License-Identifier: GPL-3.0-or-later
// The closing fit of the faces, not the vertices, to the samples.
//
// Growth draws vertices towards samples, so the vertices come to lie on the surface or, where it
// bends, inside it, and the faces cut it short. The fit moves the vertices so that the faces lie
// on the surface in the least-squares sense, which is what errors are measured by.
#pragma once

#include "core/network/growing_network.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/random.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Gauss-Newton sweeps, each over fresh samples and with a smaller step than the last. Each sample
/// is projected on the star of its winner; a vertex moves in the directions that the residuals
/// around it determine: along the normal where the surface is smooth, across a crease too, in all
/// directions at a corner.
///
/// The step is a posterior mean: the samples speak with the precision of their scatter, the
/// neighbours say how far the vertex is likely to stand out from them and where along the surface
/// it belongs. So noise is smoothed as far as it hides relief, and faces keep their shape. A sample
/// far off, measured by the residuals around it, hardly pulls. Between sweeps, edges flip where
/// that evens out valences.
///
/// No face turns over, and vertices of faces that come to intersect go back to where they were.
/// Returns how many faces intersect another in spite of that.
int fitSurface(GrowingNetwork &network, const Sampler &sampler, Random &random,
               const Progress &progress);

} // namespace neuralmesh
