// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where meshes of the host become plain ones of the core, and the other way round.
#pragma once

#include <vector>

#include "document.h"
#include "neuralmesh/attribute_transfer.h"
#include "neuralmesh/geometry.h"

namespace neuralmesh::meshlab2 {

using Layer = Document::MeshEntry;

bool hasColour(const Layer &layer);
bool hasQuality(const Layer &layer);

/// The vertices that are not deleted, in order, by the layer's matrix.
std::vector<Point> worldPoints(const Layer &layer);

/// The same vertices, with the faces that are not deleted.
Mesh worldMesh(const Layer &layer);

/// Of the same vertices.
std::vector<double> qualities(const Layer &layer);
std::vector<AttributeValues> attributes(const Layer &layer);

/// Adds a layer with normals and, where there are values, those attributes that are carried.
/// Returns its index. The host gives it a name.
int addLayer(Document &document, const Mesh &mesh, const std::vector<AttributeValues> &values,
             bool withColour, bool withQuality);

} // namespace neuralmesh::meshlab2
