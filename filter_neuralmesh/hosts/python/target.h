// SPDX-License-Identifier: GPL-3.0-or-later
// What the network learns, as Python holds it.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "host_terms.h"
#include "neuralmesh/sampler.h"

namespace neuralmesh::python {

/// A target space and the length of which `max_hole_size` may be a share.
struct Target {
    std::shared_ptr<const Sampler> sampler;
    /// Of the bounding box of all points or vertices, outliers included, as the filter takes it;
    /// of the samples, where there are no points.
    double diagonal = 0;
};

/// Adds the class Target, with a function for each kind of target space, to the module.
void defineTargets(nanobind::module_ &module);

} // namespace neuralmesh::python
