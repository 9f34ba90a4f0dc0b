// SPDX-License-Identifier: GPL-3.0-or-later
// A coarse mesh of the shape of a point cloud: its handles, its parts, its inside.
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/parallel/workers.h"
#include "neuralmesh/progress.h"

namespace neuralmesh {

/// What was found, and how far it can be trusted.
struct CoarseShape {
    int cells = 0;      ///< of the grid that was fine enough, per axis
    int components = 0; ///< of the mesh
    int genus = 0;      ///< sum over the components
    /// Share of the closed surface's area that is far from all points: of membranes.
    double unsupportedShare = 0;
    /// Membranes that were taken out.
    int openings = 0;
    /// Share of the points that are far from the mesh.
    double missedShare = 0;
    /// Whether the points are of an open sheet, which a membrane closes.
    bool isSheet = false;
    /// Whether the shape persists over grids, or over all levels of the finest.
    bool isClear = false;
    /// Whether it is clear, or nothing speaks against it.
    bool isTrusted = false;
};

/// Makes `mesh` an oriented two-manifold of the shape of the points, of about `vertices` vertices,
/// without normals. It is closed but for gaps in the data that are wider than `hole`, in the unit
/// frame, where it has boundaries. The points, in the unit frame, are samples of a target space of
/// `pointCount` distinct points.
///
/// The sides are those of a winding field (winding_field.h), corrected by what a flood from outside
/// reaches (outside_flood.h). The grid is refined until the shape no longer changes and the grid is
/// as fine as the mesh is to be; its level set is decimated. Parts that hardly any point supports
/// are left out.
///
/// Tells `progress` the share of the work, as if the finest grid were needed, and throws Cancelled
/// where it says so.
CoarseShape findCoarseShape(NeuralMesh &mesh, const std::vector<Point3> &points,
                            std::size_t pointCount, int vertices, double hole, Workers &workers,
                            const Progress &progress = {});

} // namespace neuralmesh
