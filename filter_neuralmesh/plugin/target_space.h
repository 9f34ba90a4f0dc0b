// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where the filters' parameters and the document become a target space.
#pragma once

#include <memory>

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>

#include "attributes.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"

/// What the network learns.
struct TargetSpace {
    std::unique_ptr<neuralmesh::Sampler> sampler;
    /// Of what is sampled, without dots: the result is called "NAME neural mesh".
    QString name;
    /// A line for the log; empty where there is nothing to remark.
    std::string remark;
    /// Whose attributes the result may take; no layers where there are none.
    AttributeSource attributes;
};

/// Values of the parameter Source, in the order of its labels.
enum class Source { pointsOfLayer, surfaceOfLayer, pointsOfVisibleLayers, pointFile };

/// What Source offers in dialogs and scripts.
QStringList sourceLabels();

/// The target spaces of the filters "Neural Mesh Reconstruction", "... from Implicit Surface" and
/// "... from Parametric Surface". They throw InvalidInput, with a sentence for the user, where
/// there is nothing to sample, the first also Cancelled, while it reads a file.
TargetSpace makeTargetSpace(const RichParameterList &parameters, const MeshDocument &document,
                            const neuralmesh::Progress &progress);
TargetSpace makeImplicitSurface(const RichParameterList &parameters,
                                const neuralmesh::Progress &progress);
TargetSpace makeParametricSurface(const RichParameterList &parameters,
                                  const neuralmesh::Progress &progress);
