// SPDX-License-Identifier: GPL-3.0-or-later
// The target spaces that there are. Another is one more class that implements Sampler.
//
// All take world coordinates, and throw InvalidInput, or what sampler_errors.h has of it, where
// there is no surface to be found: where points are fewer than four or not finite, or lie in one
// place or on a line.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "neuralmesh/geometry.h"
#include "neuralmesh/progress.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh {

/// A point cloud: every point with the same probability (equation 1), but for outliers, which are
/// not drawn. Where `density` is given, one value for each point, not negative, points are drawn in
/// proportion to it, and none is left out as an outlier. Points that are moved cost no more memory.
std::unique_ptr<Sampler> pointCloudSampler(std::vector<Point> points,
                                           const std::vector<double> &density = {});

/// The points of a file of binary PLY, LAS or NPY, read in place: nothing of it is kept in memory.
/// Throws InvalidPointFile for all that is wrong with it; Cancelled.
std::unique_ptr<Sampler> pointFileSampler(const std::string &path, const Progress &progress = {});

/// The surface of a mesh, uniform by area. The triangles may be any set. Where `density` is given,
/// one value for each position, not negative, samples are drawn in proportion to it, linear on each
/// triangle.
std::unique_ptr<Sampler> surfaceSampler(const Mesh &mesh, const std::vector<double> &density = {});

/// An expression in the syntax of muParser, and what errors call it.
struct Formula {
    std::string name;
    std::string text;
};

/// The surface on which a function of x, y and z is zero, within a box, uniform by area.
std::unique_ptr<Sampler> implicitSurfaceSampler(const Formula &function, const Box &box,
                                                const Progress &progress = {});

/// The surface that x, y and z as functions of u and v describe, uniform by area.
std::unique_ptr<Sampler> parametricSurfaceSampler(const std::array<Formula, 3> &coordinates,
                                                  Range u, Range v, const Progress &progress = {});

} // namespace neuralmesh
