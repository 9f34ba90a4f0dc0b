// SPDX-License-Identifier: GPL-3.0-or-later
// What every target space is asked before a surface is sought in it.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/space/plain_points.h"
#include "neuralmesh/unit_frame.h"

namespace neuralmesh {

inline bool isFinite(const Point &p)
{
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

inline bool isFinite(const Point3 &p)
{
    return isFinite(toPlain(p));
}

/// Throws InvalidInput that says how many of the points are not finite and which is the first.
[[noreturn]] void refuseNotFinite(std::uint64_t notFinite, std::uint64_t points,
                                  std::uint64_t first);

/// Throws InvalidInput where a coordinate is NaN or infinite, with how many and the first.
void requireFinite(const std::vector<Point> &world);

/// The unit frame of a target space's bounds, in world coordinates. Throws InvalidInput where its
/// diagonal is zero or not finite.
UnitFrame frameOf(const vcg::Box3d &worldBounds);

/// Throws EmptyRange where the range of a variable is empty or not finite.
void requireRange(char variable, Range range);

/// Throws InvalidInput where there are fewer distinct points than a tetrahedron has.
void requireFourPoints(std::size_t distinct);

/// Whether the points, given in the unit frame, all lie on a plane. Throws InvalidInput where they
/// lie on a line; it says how many others are ignored.
bool isFlat(const std::vector<Point3> &points, std::uint64_t ignored = 0);
bool isFlat(const std::vector<Point> &points, std::uint64_t ignored);

/// Densities as shares of the largest; empty where none are given. Throws InvalidDensity where
/// there is not one for each point, where one is negative, NaN or infinite, and where all are 0.
std::vector<double> densityShares(std::vector<double> density, std::size_t points);

} // namespace neuralmesh
