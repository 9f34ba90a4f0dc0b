// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_progress.h"

#include <chrono>

neuralmesh::Progress throttledProgress(vcg::CallBackPos *callback)
{
    if (callback == nullptr)
        return {};
    using Clock = std::chrono::steady_clock;
    static constexpr auto interval = std::chrono::milliseconds(100);
    auto last = Clock::now() - interval;
    return [callback, last](double fraction, const char *activity) mutable {
        const auto now = Clock::now();
        if (now - last < interval)
            return true;
        last = now;
        return callback(static_cast<int>(100 * fraction), activity);
    };
}
