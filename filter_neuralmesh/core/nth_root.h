// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace neuralmesh {

/// By multiplications only, which are the same everywhere: the C library's pow() is not, and the
/// same seed has to give the same mesh.
inline double power(double base, std::uint64_t exponent)
{
    double result = 1;
    for (double square = base; exponent > 0; exponent /= 2, square *= square)
        if (exponent % 2 == 1)
            result *= square;
    return result;
}

/// The n-th root of a number in (0, 1), n >= 1, to a few units of the last place, the same
/// everywhere.
inline double nthRoot(double number, int n)
{
    // Newton's method for x^n = number falls from 1 to the root, and ends where rounding lets it
    // fall no more.
    double root = 1;
    for (;;) {
        const double lower = power(root, static_cast<std::uint64_t>(n) - 1);
        const double next = root - (lower * root - number) / (n * lower);
        if (!(next < root))
            return root;
        root = next;
    }
}

} // namespace neuralmesh
