// SPDX-License-Identifier: GPL-3.0-or-later
// Closes a mesh over its boundaries, without new vertices.
#pragma once

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// Fills each boundary by a disc: the triangulation of least area (Barequet and Sharir 1995). In a
/// long boundary, corners are first cut off along the shortest diagonals, until a loop is left that
/// is short enough. Returns how many were filled; one whose every triangulation would double an
/// edge stays.
int fillHoles(NeuralMesh &mesh);

/// Fills those boundaries only whose disc has at most that area, and less than a third of the area
/// of the component that it is part of: the outline of a small sheet is no hole.
int fillHolesUpTo(NeuralMesh &mesh, double largestArea);

} // namespace neuralmesh
