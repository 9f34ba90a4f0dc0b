// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neuralmesh/progress.h"

namespace neuralmesh {

/// A part of the work as a whole of its own: its fractions are reported between `from` and `to`.
/// Refers to `whole`, which has to live on. Its time is up when that of the whole is.
inline Progress part(const Progress &whole, double from, double to)
{
    if (!whole)
        return Progress::silent(whole.timeUp());
    return {[&whole, from, to](double fraction, const char *activity) {
                return whole(from + (to - from) * fraction, activity);
            },
            whole.timeUp()};
}

/// Of the time of a run: the target space is opened, which is one pass over a point file.
constexpr double shareOfOpening = 0.1;

} // namespace neuralmesh
