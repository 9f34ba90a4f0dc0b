// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nanobind/nanobind.h>

namespace neuralmesh::python {

/// What LZF packed, as in compressed PCD files: `size` bytes. Raises ValueError where `packed` does
/// not unpack to exactly so many; no byte of it is trusted.
nanobind::bytes lzfDecompressed(const nanobind::bytes &packed, std::size_t size);

} // namespace neuralmesh::python
