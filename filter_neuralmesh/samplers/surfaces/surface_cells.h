// SPDX-License-Identifier: GPL-3.0-or-later
// Where in a box an implicit surface is: a grid of cubes, and those of them that may hold it.
#pragma once

#include <vector>

#include "neuralmesh/errors.h"
#include "neuralmesh/progress.h"
#include "samplers/surfaces/expression.h"

namespace neuralmesh {

struct SurfaceCell {
    vcg::Point3d lowest; ///< corner of the cube
    double slope;        ///< the function is taken to change no faster within it
};

struct SurfaceCells {
    vcg::Box3d box;                 ///< that all of the surface was found in
    double size = 0;                ///< of a cube
    std::vector<SurfaceCell> cells; ///< cubes that may hold the surface
};

/// Lays about 64^3 cubes in the box, then again in what is left of it, until it fits the surface.
/// A cube may hold the surface where the function changes its sign among the corners and the
/// centre, or would if it varied half as much again as between them: what is missed lies between
/// these and is smaller than a cube.
///
/// Throws InvalidInput, naming the expression, where it is not finite in the box, and where no
/// cube may hold the surface; Cancelled.
SurfaceCells findSurfaceCells(const Expression &function, const vcg::Box3d &box,
                              const Progress &progress = {});

/// The error where no surface is found.
InvalidInput noSurface(const Expression &function);

} // namespace neuralmesh
