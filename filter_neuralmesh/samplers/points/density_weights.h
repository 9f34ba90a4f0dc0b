// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "neuralmesh/geometry.h"

namespace neuralmesh {

/// How much points weigh when they are drawn, where their density varies or some are repeated: what
/// a scanner sees from near has most of the points, and were each as likely as any other it would
/// have all vertices but a few. `pointAt(place)` gives the points in an order in which those that
/// follow each other are near each other. Entry i of n is the weight of each point from place
/// i * count / n up to the next entry's; there are none where all weigh the same.
///
/// The weight is the spacing to the power of 2/3, so that samples are as dense as the points to
/// that power: vertices are as dense as samples, and so placed, the mean distance from a point of a
/// surface to the nearest of them is the least that there is (Zador 1982, in two dimensions). By
/// the square, whose optimum is the power of 1/2, strays would count for more where points are few.
/// Points at the very same place weigh as much as one.
std::vector<double> weightsByDensity(std::uint64_t count,
                                     const std::function<Point(std::uint64_t)> &pointAt);

} // namespace neuralmesh
