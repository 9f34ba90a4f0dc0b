// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace neuralmesh {

/// A change of sign: function values `low` and `high` at `a` < `b`, one of them negative.
struct Bracket {
    double a, b;
    double low, high;
};

/// The root in a bracket, to `tolerance`, by the ITP method (Oliveira and Takahashi 2020): the
/// secant, drawn towards the middle, so that it never takes more steps than bisection and one, and
/// on smooth functions far fewer.
template <class Function>
double findRoot(const Function &function, Bracket bracket, double tolerance)
{
    auto [a, b, low, high] = bracket;
    const double sign = high > 0 ? 1 : -1;
    const double pull = 0.2 / (b - a);
    double slack = 2 * tolerance;
    while (slack < b - a)
        slack *= 2;
    // `slack` is how wide the bracket of a bisection would be, or twice that.
    while (b - a > 2 * tolerance) {
        const double middle = (a + b) / 2;
        const double secant = (b * low - a * high) / (low - high);
        const double towards = middle < secant ? -1 : 1;
        const double step = std::min(pull * (b - a) * (b - a), std::abs(middle - secant));
        const double truncated = secant + towards * step;
        const double reach = std::max(slack - (b - a) / 2, 0.0);
        double x = std::abs(truncated - middle) <= reach ? truncated : middle - towards * reach;
        if (!(x > a && x < b)) // where values are too large for the secant
            x = middle;
        const double value = function(x);
        if (value == 0)
            return x;
        (sign * value > 0 ? b : a) = x;
        (sign * value > 0 ? high : low) = value;
        slack /= 2;
    }
    return (a + b) / 2;
}

} // namespace neuralmesh
