// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace neuralmesh {

/// The n-th root of a number in (0, 1), n >= 1, to a few units of the last place. Of additions,
/// multiplications and divisions only, which are the same everywhere: the C library's pow() is not,
/// and the same seed has to give the same mesh.
inline double nthRoot(double number, int n)
{
    // Newton's method for x^n = number falls from 1 to the root, and ends where rounding lets it
    // fall no more.
    double root = 1;
    for (;;) {
        double power = 1; // root^(n - 1)
        double square = root;
        for (int exponent = n - 1; exponent > 0; exponent /= 2) {
            if (exponent % 2 == 1)
                power *= square;
            square *= square;
        }
        const double next = root - (power * root - number) / (n * power);
        if (!(next < root))
            return root;
        root = next;
    }
}

} // namespace neuralmesh
