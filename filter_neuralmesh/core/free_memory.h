// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory there is for a mesh, and how much it takes.
#pragma once

#include <cstdint>

namespace neuralmesh {

/// Bytes that this process can still take without pushing others out, or as many as there are where
/// the system does not say.
std::uint64_t freeMemory();

/// Throws TooLittleMemory where a network of so many vertices takes more than `free` bytes.
void requireMemory(int vertices, std::uint64_t free = freeMemory());

} // namespace neuralmesh
