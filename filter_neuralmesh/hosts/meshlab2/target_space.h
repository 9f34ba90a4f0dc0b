// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where a filter's values and the document become what the network learns.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "layers.h"
#include "meshfilterplugin.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh::meshlab2 {

struct TargetSpace {
    std::unique_ptr<Sampler> sampler;
    /// Those that are sampled; none for files and expressions.
    std::vector<int> layers;
    bool onFaces = false;
    /// For the log; empty where there is nothing to remark.
    std::string remark;
};

/// Throw InvalidInput, with a sentence for the user, where there is nothing to sample; Cancelled.
TargetSpace layersOrFile(const MeshFilterParameterValues &values, const Document &document,
                         const Progress &progress);
TargetSpace implicitSurface(const MeshFilterParameterValues &values, const Progress &progress);
TargetSpace parametricSurface(const MeshFilterParameterValues &values, const Progress &progress);

} // namespace neuralmesh::meshlab2
