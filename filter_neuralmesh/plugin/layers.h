// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where layers of the host's document become points, and the network a layer.
#pragma once

#include <common/ml_document/mesh_document.h>

#include "core/neural_mesh.h"
#include "core/unit_frame.h"

/// The current layer. Throws InvalidInput where the document has none.
const MeshModel &currentLayer(const MeshDocument &document);

/// The layer's vertices that are not deleted, in world coordinates: with the layer's matrix.
std::vector<vcg::Point3d> worldPoints(const MeshModel &layer);

/// Label of the result: "NAME neural mesh", without the dots that the host would take for a
/// file's extension.
QString resultLabel(const MeshModel &input);

/// Adds the network to the document as a new layer, current, with an identity matrix, in world
/// coordinates, normals computed. The network needs its faces.
void addLayer(MeshDocument &document, const neuralmesh::NeuralMesh &network,
              const neuralmesh::UnitFrame &frame, const QString &label);
