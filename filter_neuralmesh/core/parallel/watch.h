// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neuralmesh/progress.h"

namespace neuralmesh {

/// Thrown where the time of a run is up. It does not leave the core: what catches it goes on with
/// the mesh so far.
struct TimeIsUp {};

/// Where long work looks, at the least every tenth of a second, whether it is to go on. What looks
/// is between two whole steps: the mesh is sound then.
class Watch {
public:
    /// Of work that nothing ends before its time.
    Watch() = default;
    /// Refers to `progress`, which has to live on.
    explicit Watch(const Progress &progress) : progress_(&progress) {}

    /// Tells how far the work is, and looks.
    void report(double fraction, const char *activity)
    {
        fraction_ = fraction;
        activity_ = activity;
        look();
    }

    /// Tells the same as last time. Throws Cancelled, and TimeIsUp. On the thread of the run.
    void look() const
    {
        if (progress_ == nullptr)
            return;
        neuralmesh::report(*progress_, fraction_, activity_);
        if (minds_ && progress_->isTimeUp())
            throw TimeIsUp();
    }

    bool isTimeUp() const { return progress_ != nullptr && progress_->isTimeUp(); }

    /// Whether the time matters; it does not to what closes a run, which may only be cancelled.
    void mindTime(bool minds) { minds_ = minds; }

private:
    const Progress *progress_ = nullptr;
    double fraction_ = 0;
    const char *activity_ = "Reading the input";
    bool minds_ = true;
};

} // namespace neuralmesh
