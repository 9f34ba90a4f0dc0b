// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where the filters' parameters and the document become a target space.
#pragma once

#include <memory>

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>

#include "attributes.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"

/// Values of the parameter Source, in the order of its labels; none of the other filters.
enum class Source { pointsOfLayer, surfaceOfLayer, pointsOfVisibleLayers, pointFile, none };

/// What a result was made of: the layer's id where it was one layer.
struct Origin {
    Source source = Source::none;
    unsigned int layer = 0;
};

/// What the network learns.
struct TargetSpace {
    std::unique_ptr<neuralmesh::Sampler> sampler;
    /// Of what is sampled, without dots: the result is called "NAME neural mesh".
    QString name;
    /// For the log, sentences; empty where there is nothing to remark.
    std::string remark;
    /// Whose attributes the result may take; no layers where there are none.
    AttributeSource attributes;
    Origin origin = {};
};

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
