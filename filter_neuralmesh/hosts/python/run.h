// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace neuralmesh::python {

/// Adds Parameters, reconstruct() and transfer_attributes() to the module.
void defineReconstruction(nanobind::module_ &module);

} // namespace neuralmesh::python
