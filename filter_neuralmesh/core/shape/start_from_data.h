// SPDX-License-Identifier: GPL-3.0-or-later
// A starting mesh with the handles and parts of the samples.
#pragma once

#include "core/mesh/neural_mesh.h"
#include "core/parallel/workers.h"
#include "core/shape/coarse_shape.h"
#include "neuralmesh/parameters.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// Makes `mesh` a coarse mesh of the shape of the samples. The shape is not trusted either where it
/// needs more vertices than the target has; `mesh` is then of no use. Throws Cancelled where
/// `progress` says so.
CoarseShape startFromData(NeuralMesh &mesh, const Sampler &sampler,
                          const GrowthParameters &parameters, Workers &workers,
                          const Progress &progress = {});

} // namespace neuralmesh
