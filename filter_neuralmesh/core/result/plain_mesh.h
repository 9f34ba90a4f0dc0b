// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/geometry.h"
#include "neuralmesh/unit_frame.h"

namespace neuralmesh {

/// The network in world coordinates: its vertices in order of their ids, without the slots of
/// removed ones, and its faces, which rebuildFaces() has to have made.
Mesh plainMesh(const NeuralMesh &network, const UnitFrame &frame);

/// Makes `network` the closed two-manifold that the mesh is, in the unit frame. Throws
/// InvalidStartingMesh where a coordinate is not finite, where a triangle names a position that is
/// not there, and as makeManifold() does.
void makeNetwork(NeuralMesh &network, const Mesh &mesh, const UnitFrame &frame);

} // namespace neuralmesh
