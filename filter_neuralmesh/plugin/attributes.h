// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex colour and quality of the input's layers on the result.
#pragma once

#include <vector>

#include <common/ml_document/mesh_document.h>

#include "neuralmesh/attribute_transfer.h"

/// Layers whose attributes the result may take: those of their vertices, or of places all over
/// their faces, between the vertices' values.
struct AttributeSource {
    std::vector<const MeshModel *> layers;
    bool onFaces = false;
};

/// Of the vertices of a result. Empty values: nothing to transfer.
struct Attributes {
    bool hasColour = false;
    bool hasQuality = false;
    std::vector<neuralmesh::AttributeValues> values;
};

/// Averages the layers' colours and qualities onto the result's vertices, as far as any layer has
/// them. Looks at a bounded number of points for each vertex, whatever the layers' size.
Attributes transferAttributes(const AttributeSource &source, const neuralmesh::Mesh &mesh,
                              const neuralmesh::Progress &progress);

/// Gives the attributes to the layer made of the same result.
void setAttributes(MeshModel &layer, const Attributes &attributes);
