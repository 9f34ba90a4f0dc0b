// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_progress.h"

#include <algorithm>
#include <chrono>

neuralmesh::Progress throttledProgress(vcg::CallBackPos *callback,
                                       const neuralmesh::Deadline &deadline)
{
    if (callback == nullptr)
        return neuralmesh::Progress::silent(deadline);
    using Clock = std::chrono::steady_clock;
    static constexpr auto interval = std::chrono::milliseconds(100);
    auto last = Clock::now() - interval;
    // What a phase does not know beforehand it may overestimate; a bar that runs back tells
    // nothing.
    const auto pass = [callback, last, furthest = 0](double fraction,
                                                     const char *activity) mutable {
        const auto now = Clock::now();
        if (now - last < interval)
            return true;
        last = now;
        furthest = std::max(furthest, static_cast<int>(100 * fraction));
        return callback(furthest, activity);
    };
    return {pass, deadline};
}
