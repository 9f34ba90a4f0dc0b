// SPDX-License-Identifier: GPL-3.0-or-later
// What compilers differ in. No other file asks for the compiler.
#pragma once

#include <cmath>

#ifndef M_PI // which the standard does not know
#define M_PI 3.14159265358979323846
#endif

namespace neuralmesh {

/// Whether the highest byte of a number comes first in memory. Compilers that do not say so are
/// those of little-endian machines.
#if defined(__BYTE_ORDER__)
inline constexpr bool hostIsBigEndian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
#else
inline constexpr bool hostIsBigEndian = false;
#endif

/// Asks the memory for what will be read soon. Changes nothing but the time.
inline void prefetch([[maybe_unused]] const void *address)
{
#if defined(__GNUC__) // clang++ defines it too
    __builtin_prefetch(address);
#endif
}

} // namespace neuralmesh
