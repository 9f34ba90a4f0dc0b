// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where layers of the host's document become points and meshes, and a result a layer.
#pragma once

#include <common/ml_document/mesh_document.h>

#include "neuralmesh/geometry.h"

/// The current layer. Throws InvalidInput where the document has none.
const MeshModel &currentLayer(const MeshDocument &document);

/// The layer with this id. Throws InvalidInput, speaking of StartLayer, where there is none.
const MeshModel &startLayer(const MeshDocument &document, unsigned int id);

/// A layer as the core takes it: vertices and faces that are not deleted, in world coordinates,
/// with the layer's matrix. Vertices are numbered without the deleted ones, as users see them.
std::vector<neuralmesh::Point> worldPoints(const MeshModel &layer);
neuralmesh::Mesh worldMesh(const MeshModel &layer);

/// Quality of the same vertices. Throws InvalidInput where the layer has none.
std::vector<double> vertexQualities(const MeshModel &layer);

/// A layer's label, without its extension and without dots.
QString nameOf(const MeshModel &layer);

/// Without the dots that the host would take for a file's extension.
QString withoutDots(QString name);

/// Adds the result to the document as a new layer, current, with an identity matrix, normals
/// computed, its vertices and faces in the same order. The label must not have dots.
MeshModel &addLayer(MeshDocument &document, const neuralmesh::Mesh &result, const QString &label);
