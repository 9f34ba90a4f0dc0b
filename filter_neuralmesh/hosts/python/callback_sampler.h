// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "neuralmesh/sampler.h"

namespace neuralmesh::python {

/// A target space that Python samples, in batches of thousands: draw(seed, count) returns `count`
/// points, count x 3 of float64, within the box. The seed, 64 bits, is all the randomness it uses.
/// Throws, also from draw(), what Python raises.
std::unique_ptr<Sampler> callbackSampler(nanobind::object draw, const Box &box, bool isFlat);

} // namespace neuralmesh::python
