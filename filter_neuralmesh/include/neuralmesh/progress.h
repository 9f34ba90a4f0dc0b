// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "neuralmesh/errors.h"

namespace neuralmesh {

/// Told the share of the work that is done, in [0, 1], and what is being done. Returns false to
/// cancel. The core calls it often (every few thousand signals); a host that wants fewer calls
/// throttles them, since the core reads no clock.
using Progress = std::function<bool(double fraction, const char *activity)>;

/// Reports progress where there is anyone to report to. Throws Cancelled when told to stop.
inline void report(const Progress &progress, double fraction, const char *activity)
{
    if (progress && !progress(fraction, activity))
        throw Cancelled();
}

} // namespace neuralmesh
