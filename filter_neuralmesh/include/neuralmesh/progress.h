// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <type_traits>
#include <utility>

#include "neuralmesh/errors.h"

namespace neuralmesh {

/// Whom the work reports to, and until when it may last.
class Progress {
public:
    /// Told the share of the work that is done, in [0, 1], and what is being done. Returns false to
    /// cancel. The core calls it often (every few thousand signals); a host that wants fewer calls
    /// throttles them.
    using Callback = std::function<bool(double fraction, const char *activity)>;

    /// Whether the work is to end with what there is so far: such as a Deadline.
    using TimeUp = std::function<bool()>;

    Progress() = default;
    template <class Function,
              class = std::enable_if_t<std::is_constructible_v<Callback, Function &&> &&
                                       !std::is_same_v<std::decay_t<Function>, Progress>>>
    Progress(Function &&callback, TimeUp timeUp = {})
        : callback_(std::forward<Function>(callback)), timeUp_(std::move(timeUp))
    {
    }
    /// Reports to nobody.
    static Progress silent(TimeUp timeUp) { return {Callback(), std::move(timeUp)}; }

    /// Whether there is anyone to report to.
    explicit operator bool() const { return static_cast<bool>(callback_); }

    /// Whether the work is to go on, which it is where nobody listens.
    bool operator()(double fraction, const char *activity) const
    {
        return !callback_ || callback_(fraction, activity);
    }

    const TimeUp &timeUp() const { return timeUp_; }
    bool isTimeUp() const { return timeUp_ && timeUp_(); }

private:
    Callback callback_;
    TimeUp timeUp_;
};

/// Reports progress where there is anyone to report to. Throws Cancelled when told to stop.
inline void report(const Progress &progress, double fraction, const char *activity)
{
    if (!progress(fraction, activity))
        throw Cancelled();
}

} // namespace neuralmesh
